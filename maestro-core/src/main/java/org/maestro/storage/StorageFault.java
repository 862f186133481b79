package org.maestro.storage;

import java.io.IOException;
import java.nio.channels.ClosedChannelException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.Objects;

/** Why storage does not take what is to be kept, as a clause; Java says of some only the file. */
public final class StorageFault {
  private StorageFault() {}

  public static String words(IOException failure) {
    if (failure instanceof NoSuchFileException gone) {
      return "there is no " + gone.getFile() + " any more";
    }
    if (failure instanceof AccessDeniedException denied) {
      return denied.getFile() + " may not be written";
    }
    if (failure instanceof FileSystemException known && known.getReason() != null) {
      return known.getFile() + ": " + known.getReason();
    }
    if (failure instanceof ClosedChannelException) {
      return "the file was closed";
    }
    return Objects.requireNonNullElse(failure.getMessage(), failure.toString());
  }
}
