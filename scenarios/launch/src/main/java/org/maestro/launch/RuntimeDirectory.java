package org.maestro.launch;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The user's own directory for what running platforms leave: who runs where, the last stories,
 * pictures and the log. Nobody else can read it.
 */
final class RuntimeDirectory {
  private static final String RUNNING = ".platform.json";
  private static final String LAST = "last-story";

  private final Path directory;
  private final ObjectMapper json = new ObjectMapper();

  /**
   * A platform that runs, as told to other commands.
   *
   * @param security where the files of its site are, if that is secured
   * @param console where its console answers, if it has one
   */
  record Running(
      String name,
      long pid,
      String host,
      int port,
      Optional<String> broker,
      Optional<String> security,
      Optional<URI> console) {
    boolean isAlive() {
      return ProcessHandle.of(pid).map(ProcessHandle::isAlive).orElse(false);
    }
  }

  private RuntimeDirectory(Path directory) {
    this.directory = directory;
  }

  static RuntimeDirectory ofUser() {
    String given = System.getenv("XDG_RUNTIME_DIR");
    Path wanted =
        given != null && !given.isBlank() && Files.isWritable(Path.of(given))
            ? Path.of(given, "maestro")
            : Path.of(System.getProperty("user.home"), ".maestro", "run");
    return new RuntimeDirectory(wanted);
  }

  static RuntimeDirectory at(Path directory) {
    return new RuntimeDirectory(directory);
  }

  /** Has the log written here; to be called before anything logs. */
  void prepareLog() {
    System.setProperty("maestro.log", ready().resolve("maestro.log").toString());
  }

  Path log() {
    return directory.resolve("maestro.log");
  }

  /**
   * Where the stories of a platform of this name are kept; {@code why} reads the last ones begun.
   */
  Path beginStories(String platform) {
    Path stories = ready().resolve("stories").resolve(platform);
    write(directory.resolve(LAST), platform);
    return stories;
  }

  /** The same, for stories that are kept elsewhere. */
  Path beginStories(Path elsewhere) {
    Path stories = elsewhere.toAbsolutePath();
    ready();
    write(directory.resolve(LAST), stories.toString());
    return stories;
  }

  /** The stories of the platform that was started last. */
  Optional<Path> lastStories() {
    Path last = directory.resolve(LAST);
    if (!Files.exists(last)) {
      return Optional.empty();
    }
    try {
      return Optional.of(directory.resolve("stories").resolve(Files.readString(last)));
    } catch (IOException e) {
      throw CommandException.outside("The file " + last + " cannot be read.", e);
    }
  }

  Path picture(String name) {
    return ready().resolve(name + ".png");
  }

  void add(Running platform) {
    ObjectNode node = json.createObjectNode();
    node.put("name", platform.name());
    node.put("pid", platform.pid());
    node.put("host", platform.host());
    node.put("port", platform.port());
    platform.broker().ifPresent(uri -> node.put("broker", uri));
    platform.security().ifPresent(files -> node.put("security", files));
    platform.console().ifPresent(uri -> node.put("console", uri.toString()));
    write(ready().resolve(platform.name() + RUNNING), node.toString());
  }

  void remove(String platform) {
    try {
      Files.deleteIfExists(directory.resolve(platform + RUNNING));
    } catch (IOException e) {
      throw CommandException.outside("The file of " + platform + " cannot be removed.", e);
    }
  }

  /** The platforms that run now, by name. */
  List<Running> running() {
    if (!Files.isDirectory(directory)) {
      return List.of();
    }
    List<Running> found = new ArrayList<>();
    try (Stream<Path> files = Files.list(directory)) {
      for (Path file : files.filter(f -> f.toString().endsWith(RUNNING)).sorted().toList()) {
        var node = json.readTree(Files.readString(file));
        Running running =
            new Running(
                node.path("name").asText(),
                node.path("pid").asLong(),
                node.path("host").asText(),
                node.path("port").asInt(),
                Optional.ofNullable(node.path("broker").textValue()),
                Optional.ofNullable(node.path("security").textValue()),
                Optional.ofNullable(node.path("console").textValue()).map(URI::create));
        if (running.isAlive()) {
          found.add(running);
        }
      }
    } catch (IOException e) {
      throw CommandException.outside("The directory " + directory + " cannot be read.", e);
    }
    return found;
  }

  private Path ready() {
    try {
      Files.createDirectories(directory.getParent());
      // Another command may be making it at the same moment.
      if (hasPermissions()) {
        Files.createDirectories(
            directory,
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
      } else {
        Files.createDirectories(directory);
      }
      return directory;
    } catch (IOException e) {
      throw CommandException.outside(
          "The directory " + directory + " cannot be made; set XDG_RUNTIME_DIR to one that can.",
          e);
    }
  }

  /** Others find the file as it was or as it is now, and nobody else can read it. */
  private void write(Path file, String text) {
    try {
      Path made = Files.createTempFile(directory, "", ".new");
      Files.writeString(made, text);
      Files.move(made, file, StandardCopyOption.ATOMIC_MOVE);
    } catch (IOException e) {
      throw CommandException.outside("The file " + file + " cannot be written.", e);
    }
  }

  private static boolean hasPermissions() {
    return FileSystems.getDefault().supportedFileAttributeViews().contains("posix");
  }
}
