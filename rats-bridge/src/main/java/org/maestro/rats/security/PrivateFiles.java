package org.maestro.rats.security;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;

/** Files that only their owner may read and write: mode 600, in directories of mode 700. */
final class PrivateFiles {

  private static final Set<PosixFilePermission> OF_OTHERS =
      PosixFilePermissions.fromString("---rwxrwx");

  /** Names of files that hold a secret, wherever they are below the directory of a site. */
  static final Set<String> SECRETS =
      Set.of(
          "password",
          "console-password",
          "key.pem",
          "container-key.pem",
          "join-token",
          "passwords",
          "users.properties",
          "broker.xml",
          "broker.p12",
          "trust.p12");

  private PrivateFiles() {}

  static void directory(Path directory) {
    try {
      Files.createDirectories(directory, mode(directory, "rwx------"));
    } catch (IOException refused) {
      throw new SecurityFilesException(
          "The directory " + directory + " cannot be made; choose one that you may write to.",
          refused);
    }
  }

  static void write(Path file, String text) {
    write(file, text.getBytes(UTF_8));
  }

  /** Replaces the file at once: who reads it sees the old or the new one. */
  static void write(Path file, byte[] bytes) {
    directory(Objects.requireNonNull(file.toAbsolutePath().getParent()));
    Path draft = file.resolveSibling("." + file.getFileName() + ".new");
    try {
      Files.deleteIfExists(draft);
      Files.createFile(draft, mode(draft, "rw-------"));
      Files.write(draft, bytes);
      Files.move(draft, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    } catch (IOException refused) {
      throw new SecurityFilesException(
          "The file " + file + " cannot be written; see to the directory's rights and the disk.",
          refused);
    }
  }

  /** Deletes a directory with the files in it, if it is there. */
  static void delete(Path directory) {
    if (!Files.exists(directory)) {
      return;
    }
    try (Stream<Path> files = Files.list(directory)) {
      for (Path file : files.toList()) {
        Files.delete(file);
      }
      Files.delete(directory);
    } catch (IOException refused) {
      throw new SecurityFilesException(
          "The directory " + directory + " cannot be deleted; delete it yourself.", refused);
    }
  }

  static String text(Path file) {
    return new String(bytes(file), UTF_8);
  }

  /** Reads a file that holds no secret. */
  static byte[] bytes(Path file) {
    if (!Files.isRegularFile(file)) {
      throw new SecurityFilesException(
          "The security file " + file + " is missing; ./maestro secure makes it.");
    }
    try {
      return Files.readAllBytes(file);
    } catch (IOException unreadable) {
      throw new SecurityFilesException(
          "The security file " + file + " cannot be read; give yourself the right to.", unreadable);
    }
  }

  /** Reads a secret, which must be open to nobody else. */
  static String secret(Path file) {
    String text = text(file);
    requirePrivate(file);
    return text;
  }

  /**
   * Requires of each secret file below a site's directory, of whomever it is, that it is open to
   * nobody else.
   */
  static void requireSecretsPrivate(Path directory) {
    try (Stream<Path> files = Files.walk(directory)) {
      files
          .filter(file -> SECRETS.contains(file.getFileName().toString()))
          .sorted()
          .forEach(PrivateFiles::requirePrivate);
    } catch (IOException | UncheckedIOException unreadable) {
      throw new SecurityFilesException(
          "The directory %s cannot be looked through (%s); give yourself the right to."
              .formatted(directory, unreadable.getMessage()),
          unreadable);
    }
  }

  static void requirePrivate(Path file) {
    try {
      if (hasModes(file)
          && Files.getPosixFilePermissions(file, LinkOption.NOFOLLOW_LINKS).stream()
              .anyMatch(OF_OTHERS::contains)) {
        throw new SecurityFilesException(
            "The security file " + file + " is open to other users; run chmod 600 on it.");
      }
    } catch (IOException unreadable) {
      throw new SecurityFilesException(
          "The rights of the security file " + file + " cannot be read.", unreadable);
    }
  }

  private static FileAttribute<?>[] mode(Path path, String mode) {
    return hasModes(path)
        ? new FileAttribute<?>[] {
          PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString(mode))
        }
        : new FileAttribute<?>[0];
  }

  private static boolean hasModes(Path path) {
    return path.getFileSystem().supportedFileAttributeViews().contains("posix");
  }
}
