package org.maestro.platform.journal;

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
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Objects;
import java.util.Optional;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.storage.StorageFault;

/**
 * The right to use a data directory, which one process has at a time; the system takes it back when
 * the process dies. One thread at a time.
 */
final class DirectoryLock implements AutoCloseable {
  private static final String NAME = "lock";

  private final Path directory;
  private FileChannel channel;
  private Object key;

  private DirectoryLock(Path directory, FileChannel channel) throws IOException {
    this.directory = directory;
    this.channel = channel;
    this.key = key(directory);
  }

  /** By which the system tells the file from another of its name. */
  private static Object key(Path directory) throws IOException {
    return Files.readAttributes(directory.resolve(NAME), BasicFileAttributes.class).fileKey();
  }

  /**
   * Makes the directory when it is not there.
   *
   * @throws PlatformStartException when somebody else has it, or it cannot be made
   */
  static DirectoryLock take(Path directory) {
    try {
      create(directory);
      return new DirectoryLock(directory, locked(directory));
    } catch (IOException e) {
      throw new PlatformStartException(
          "The directory %s cannot be used (%s); name one that can be written."
              .formatted(directory, StorageFault.words(e)),
          e);
    }
  }

  /**
   * Takes it again when somebody has removed the file, or the whole directory was gone for a while.
   *
   * @throws PlatformStartException when somebody else has it now
   */
  void keep() throws IOException {
    if (!Files.exists(directory.resolve(NAME)) || !Objects.equals(key(directory), key)) {
      FileChannel again = locked(directory);
      channel.close();
      channel = again;
      key = key(directory);
    }
  }

  private static FileChannel locked(Path directory) throws IOException {
    FileChannel channel =
        FileChannel.open(
            directory.resolve(NAME),
            StandardOpenOption.CREATE,
            StandardOpenOption.READ,
            StandardOpenOption.WRITE);
    try {
      if (tried(channel).isEmpty()) {
        throw new PlatformStartException(
            "The directory %s is in use by another platform%s; stop it, or name another directory."
                .formatted(directory, holder(channel)));
      }
      byte[] process = Long.toString(ProcessHandle.current().pid()).getBytes(UTF_8);
      channel.truncate(0);
      channel.write(ByteBuffer.wrap(process), 0);
      return channel;
    } catch (IOException | PlatformStartException e) {
      channel.close();
      throw e;
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
