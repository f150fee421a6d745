// A picture as the browser draws it.
import { ServiceError } from "./client";

const scale = 2; // pixels, for screens and print

export async function pngOf(svg: string): Promise<Blob> {
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), {
      width: scale * image.naturalWidth,
      height: scale * image.naturalHeight,
    });
    canvas.getContext("2d")!.drawImage(image, 0, 0, canvas.width, canvas.height);
    const png = await new Promise<Blob | null>((done) => canvas.toBlob(done, "image/png"));
    if (png) return png;
  } catch {
    // said below
  } finally {
    URL.revokeObjectURL(address);
  }
  throw new ServiceError("refused", "The browser cannot draw the picture. “SVG” holds the same.");
}
