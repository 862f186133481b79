package org.maestro.console.history;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

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
        return Files.newOutputStream(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
      }

      @Override
      public long room(Path directory) throws IOException {
        return Files.getFileStore(directory).getUsableSpace();
      }
    };
  }
}
