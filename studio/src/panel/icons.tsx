// Icons: 20 by 20, drawn with the colour of the text around them.
const shapes = {
  undo: "M7 4 3.5 7.5 7 11M4 7.5h7.5a4.5 4.5 0 0 1 0 9H8",
  redo: "M13 4l3.5 3.5L13 11M16 7.5H8.5a4.5 4.5 0 0 0 0 9H12",
  link: "M8.5 11.5a3 3 0 0 0 4.3 0l2.8-2.8a3 3 0 0 0-4.3-4.3l-1 1M11.5 8.5a3 3 0 0 0-4.3 0l-2.8 2.8a3 3 0 0 0 4.3 4.3l1-1",
  help: "M10 17.5a7.5 7.5 0 1 0 0-15 7.5 7.5 0 0 0 0 15ZM7.8 8a2.2 2.2 0 1 1 3.3 1.9c-.8.5-1.1.9-1.1 1.7M10 14v.2",
  close: "M5 5l10 10M15 5 5 15",
  check: "M4 10.5 8 14.5 16 6",
  warning: "M10 3 18 17H2ZM10 8.5v3.5M10 14.4v.2",
  about: "M3 8.2c2.3-2.4 4.7-2.4 7 0s4.7 2.4 7 0M3 13.2c2.3-2.4 4.7-2.4 7 0s4.7 2.4 7 0",
  move: "M10 3v14M3 10h14M8 5l2-2 2 2M8 15l2 2 2-2M5 8l-2 2 2 2M15 8l2 2-2 2",
  wall: "M3 5h14v10H3ZM3 10h14M8 5v5M12 10v5",
  erase:
    "M8.5 16 3.8 11.3a1.5 1.5 0 0 1 0-2.1l5.4-5.4a1.5 1.5 0 0 1 2.1 0l4.3 4.3a1.5 1.5 0 0 1 0 2.1L10 16ZM7 6.5l6.5 6.5M8 16h9",
  zone: "M4 6.5 11 3l5.5 5-2 8.5H5.5ZM2.8 6.5a1.2 1.2 0 1 0 2.4 0 1.2 1.2 0 1 0-2.4 0",
  base: "M3.5 3.5h13v13h-13ZM6 8h7v4H6ZM13 9.5h1.5v1H13",
  rubble: "M2.5 16.5 6 11l4.5 1.5 2 4ZM10 12l2.5-5 4.5 3.5.5 6h-5M7 8l2.5-4 3 1.5",
  protect: "M10 2.5 16 5v4.5c0 3.8-2.5 6.6-6 8-3.5-1.4-6-4.2-6-8V5Z",
  force: "M11 2.5 4.5 11.5H9.5L8.5 17.5 15.5 8H10.5Z",
  exclude: "M10 17a7 7 0 1 0 0-14 7 7 0 0 0 0 14ZM5.2 5.2l9.6 9.6",
  open: "M3 15.5v-10h4.5l1.5 2h8v8ZM10 13.5v-4M8.2 11 10 9.3l1.8 1.7",
  download: "M10 3.5v8.5M6.5 9l3.5 3.5L13.5 9M4 16.5h12",
  stop: "M5.5 5.5h9v9h-9Z",
} as const;

export type IconName = keyof typeof shapes;

export function Icon({ name }: { name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 20 20" width="20" height="20" aria-hidden="true">
      <path d={shapes[name]} />
    </svg>
  );
}

// The project's logo: a path through what blocked it.
export function Sign() {
  return (
    <svg class="sign" viewBox="0 0 28 28" width="28" height="28" aria-hidden="true">
      <path class="sign-wall" d="M3 11h7v6H3ZM18 11h7v6h-7Z" />
      <path class="sign-gap" d="M11.5 11h5v6h-5Z" />
      <path class="sign-way" d="M7 25C9 19 14 18 14 14s1-7 6-10" />
    </svg>
  );
}
