// Outlines of sections: y, z and components of the normal.

export function circle(radius, corners = 24) {
  return Array.from({ length: corners }, (_, i) => {
    const [c, s] = [Math.cos((2 * Math.PI * i) / corners), Math.sin((2 * Math.PI * i) / corners)];
    return [radius * c, radius * s, c, s];
  });
}

export function rectangle(height, width) {
  const [a, b] = [height / 2, width / 2];
  return [
    [a, -b, 1, 0],
    [a, b, 1, 0],
    [a, b, 0, 1],
    [-a, b, 0, 1],
    [-a, b, -1, 0],
    [-a, -b, -1, 0],
    [-a, -b, 0, -1],
    [a, -b, 0, -1],
  ];
}
