package org.maestro.console.history;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** The disk that files are written to. */
interface Disk {
  /** Begins a file that is not there yet. */
  OutputStream begin(Path file) throws IOException;

  /** How many bytes more it takes, in this directory. */
  long room(Path directory) throws IOException;

  /** The one of this machine. */
  static Disk real() {
    return new Disk() {
      @Override
      public OutputStream begin(Path file) throws IOException {
        // Unlike one of a channel it stays open when the thread is interrupted at the end.
        return new FileOutputStream(file.toFile());
      }

      @Override
      public long room(Path directory) throws IOException {
        return Files.getFileStore(directory).getUsableSpace();
      }
    };
  }
}
