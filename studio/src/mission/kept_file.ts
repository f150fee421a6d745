// A map file that a person chose, read at once: it may be asked for again after it has changed or gone.
export interface KeptFile {
  name: string;
  bytes: Blob;
}

// Throws where the file cannot be read.
export async function keep(file: File): Promise<KeptFile> {
  return { name: file.name, bytes: new Blob([await file.arrayBuffer()]) };
}
