package org.maestro.platform;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Optional;

/**
 * The right to use a data directory, which one process has at a time; the system takes it back when
 * the process dies.
 */
final class DirectoryLock implements AutoCloseable {
  private static final String NAME = "lock";

  private final Path directory;
  private final FileChannel channel;

  private DirectoryLock(Path directory, FileChannel channel) {
    this.directory = directory;
    this.channel = channel;
  }

  /**
   * Makes the directory when it is not there.
   *
   * @throws PlatformStartException when somebody else has it, or it cannot be made
   */
  static DirectoryLock take(Path directory) {
    try {
      create(directory);
      FileChannel channel =
          FileChannel.open(
              directory.resolve(NAME),
              StandardOpenOption.CREATE,
              StandardOpenOption.READ,
              StandardOpenOption.WRITE);
      if (tried(channel).isEmpty()) {
        String holder = holder(channel);
        channel.close();
        throw new PlatformStartException(
            "The directory %s is in use by another platform%s; stop it, or name another directory."
                .formatted(directory, holder));
      }
      byte[] process = Long.toString(ProcessHandle.current().pid()).getBytes(UTF_8);
      channel.truncate(0);
      channel.write(ByteBuffer.wrap(process), 0);
      return new DirectoryLock(directory, channel);
    } catch (IOException e) {
      throw new PlatformStartException(
          "The directory %s cannot be used (%s); name one that can be written."
              .formatted(directory, e.getMessage()),
          e);
    }
  }

  private static void create(Path directory) throws IOException {
    if (Files.isDirectory(directory)) {
      return;
    }
    if (hasPermissions()) {
      Files.createDirectories(
          directory,
          PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
    } else {
      Files.createDirectories(directory);
    }
  }

  private static Optional<FileLock> tried(FileChannel channel) throws IOException {
    try {
      return Optional.ofNullable(channel.tryLock());
    } catch (OverlappingFileLockException e) {
      return Optional.empty();
    }
  }

  private static String holder(FileChannel channel) throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(32);
    int read = channel.read(bytes, 0);
    return read > 0 ? " (process " + new String(bytes.array(), 0, read, UTF_8).strip() + ")" : "";
  }

  /** Forces the names of the directory's files to the disk. */
  void force() throws IOException {
    if (hasPermissions()) {
      try (FileChannel names = FileChannel.open(directory, StandardOpenOption.READ)) {
        names.force(true);
      }
    }
  }

  private static boolean hasPermissions() {
    return FileSystems.getDefault().supportedFileAttributeViews().contains("posix");
  }

  @Override
  public void close() {
    try {
      channel.close();
    } catch (IOException e) {
      throw new UncheckedIOException("The directory " + directory + " cannot be let go", e);
    }
  }
}
