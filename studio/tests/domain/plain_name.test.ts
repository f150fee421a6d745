import { expect, it } from "vitest";
import { plainName, shortenedName } from "../../src/domain/plain_name";

it("turns nothing around it, and keeps what scripts need", () => {
  expect(plainName("evil\u202eliame\u202c \u2067x\u2069")).toBe("evilliame x");
  for (const name of ["Straße des 17. Juni", "בית\u200f", "مبنى", "🏢 Tower", ""]) expect(plainName(name)).toBe(name);
});

it("is shortened by letters, not by halves of them", () => {
  expect(shortenedName("🏢🏢🏢🏢", 3)).toBe("🏢🏢…");
  expect(shortenedName("abc", 3)).toBe("abc");
  expect(shortenedName("\u202eabc\u202c", 3)).toBe("abc");
});
