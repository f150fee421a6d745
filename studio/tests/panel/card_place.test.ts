// Where the card of an obstacle stands.
import { describe, expect, it } from "vitest";
import type { Point } from "../../src/domain/geometry";
import { bestCorner } from "../../src/panel/card_place";

const card = { width: 330, height: 210 };
const view = { width: 1016, height: 800 };

describe("the card of an obstacle", () => {
  it("goes aside where it would hide the goal and a removal", () => {
    const marked: Point[] = [[340, 210], [601, 240], [780, 218], [808, 214]];
    expect(bestCorner(card, view, marked, "top right")).toBe("bottom right");
    expect(bestCorner(card, view, [...marked, [900, 600]], "top right")).toBe("bottom left");
  });

  it("stays where it hides nothing", () => {
    expect(bestCorner(card, view, [[500, 400]], "top right")).toBe("top right");
    expect(bestCorner(card, view, [[500, 400]], "bottom left")).toBe("bottom left");
  });

  it("hides as little as there is to hide", () => {
    const everywhere: Point[] = [[900, 100], [900, 120], [900, 600], [100, 150], [100, 160], [150, 600], [151, 600]];
    expect(bestCorner(card, view, everywhere, "top right")).toBe("bottom right");
  });
});
