// A button that lets the person choose files. The browser's own file input is hidden, for it cannot be styled.
import type { ComponentChildren } from "preact";
import { useRef } from "preact/hooks";

interface FileButtonProps {
  primary?: boolean;
  title?: string;
  label: string; // of the input, for those who do not see the button
  onFiles: (files: File[]) => void;
  children: ComponentChildren;
}

export function FileButton({ primary = false, title, label, onFiles, children }: FileButtonProps) {
  const input = useRef<HTMLInputElement>(null);
  const style = primary ? "button primary" : "button";
  return (
    <>
      <button type="button" class={style} title={title} onClick={() => input.current?.click()}>
        {children}
      </button>
      <input
        ref={input}
        class="spoken"
        type="file"
        multiple
        tabIndex={-1}
        aria-label={label}
        onChange={(event) => {
          const files = [...(event.currentTarget.files ?? [])];
          event.currentTarget.value = ""; // so that the same file can be chosen again
          if (files.length > 0) onFiles(files);
        }}
      />
    </>
  );
}
