// Icons of the buttons: SVG paths in a box of 24 by 24.

export const ICONS = {
  play: "M8 5.5v13l10.5-6.5z",
  pause: "M7 5h3.6v14H7zM13.4 5H17v14h-3.6z",
  previous: "M6 5h2.4v14H6zM19 5.5v13L9.5 12z",
  next: "M15.6 5H18v14h-2.4zM5 5.5v13l9.5-6.5z",
  theme: "M12 3a9 9 0 1 0 0 18zM12 3a9 9 0 0 1 0 18v-1.8a7.2 7.2 0 0 0 0-14.4z",
  help: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm0 1.8a7.2 7.2 0 1 1 0 14.4 7.2 7.2 0 0 1 0-14.4zM11.1 16h1.8v1.8h-1.8zM12 6.8c-1.9 0-3.2 1.2-3.3 3h1.8c0-.8.6-1.4 1.5-1.4s1.5.5 1.5 1.3c0 1.3-2.4 1.6-2.4 4.7h1.8c0-2.1 2.4-2.3 2.4-4.7 0-1.7-1.4-2.9-3.3-2.9z",
  image:
    "M9 5l-1.4 2H4v12h16V7h-3.6L15 5zm3 4a4 4 0 1 1 0 8 4 4 0 0 1 0-8zm0 1.8a2.2 2.2 0 1 0 0 4.4 2.2 2.2 0 0 0 0-4.4z",
  video: "M4 6h11v12H4zM16.5 10.5L20 8v8l-3.5-2.5z",
  fit: "M4 4h6v1.8H5.8V10H4zM14 4h6v6h-1.8V5.8H14zM4 14h1.8v4.2H10V20H4zM18.2 14H20v6h-6v-1.8h4.2z",
  sliders: "M4 7h9v1.8H4zM17 7h3v1.8h-3zM14 5h1.8v6H14zM4 15h3v1.8H4zM11 15h9v1.8h-9zM8.2 13H10v6H8.2z",
};
