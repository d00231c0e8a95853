"use strict"; // The viewer: made by `viewer/`.
