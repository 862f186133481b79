package org.maestro.launch;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Writes starting points that run as they are. */
@Command(
    name = "new",
    description = "Write a home, a device or a scenario to start from; it runs as it is.",
    subcommands = {NewCommand.OfHome.class, NewCommand.OfDevice.class, NewCommand.OfScenario.class})
final class NewCommand implements Runnable {
  @Spec private CommandSpec spec;

  @Override
  public void run() {
    throw new ParameterException(
        spec.commandLine(), "Say what is to be new: home, device or scenario, each with a DIR.");
  }

  /**
   * How the artifacts come to where Maven looks for them: a release brings them, a clone makes
   * them, without the analysis of our own builds, which takes longer than all else.
   */
  private static String install() {
    Path program = Path.of(System.getProperty("java.class.path").split(File.pathSeparator)[0]);
    Path artifacts = program.toAbsolutePath().resolveSibling("repository");
    return Files.isDirectory(artifacts)
        ? "mkdir -p ~/.m2; cp -R \"%s\" ~/.m2, once".formatted(artifacts)
        : "mvn install -DskipTests -Dmaestro.quick, once, in the clone of MAESTRO";
  }

  /** The common part: files that come with the program, written to a directory of the user's. */
  abstract static class Written implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Parameters(paramLabel = "DIR", description = "A directory that is not there yet, or empty.")
    private Path directory;

    /** Where the files are among the resources, and which. */
    abstract Template files();

    /** What can be done with them. */
    abstract List<String> next(String where);

    @Override
    public Integer call() {
      requireEmpty();
      Template files = files();
      files.names().forEach(name -> write(name, files.text(name)));
      PrintWriter out = spec.commandLine().getOut();
      out.println("Written: " + String.join(", ", files.names()) + " in " + directory + ".");
      next(directory.toString()).forEach(out::println);
      return ExitCode.DONE;
    }

    private void requireEmpty() {
      if (!Files.exists(directory)) {
        return;
      }
      try (Stream<Path> there = Files.list(directory)) {
        if (there.findAny().isPresent()) {
          throw CommandException.badInput(
              "The directory %s is not empty; name one that is not there yet."
                  .formatted(directory));
        }
      } catch (IOException e) {
        throw CommandException.badInput(
            "%s is no directory that can be read; name one that is not there yet."
                .formatted(directory));
      }
    }

    private void write(String name, String text) {
      Path file = directory.resolve(name);
      try {
        Files.createDirectories(Objects.requireNonNull(file.getParent()));
        Files.writeString(file, text);
      } catch (IOException e) {
        throw CommandException.outside("The file " + file + " cannot be written.", e);
      }
    }
  }

  /**
   * Files among the resources.
   *
   * @param kind the directory that they stand in
   */
  record Template(String kind, List<String> names) {
    String text(String name) {
      try (InputStream file = NewCommand.class.getResourceAsStream("new/" + kind + "/" + name)) {
        return new String(Objects.requireNonNull(file, name).readAllBytes(), StandardCharsets.UTF_8)
            .replace("@version@", Version.number());
      } catch (IOException e) {
        throw CommandException.outside("The program is damaged; build it again.", e);
      }
    }
  }

  @Command(name = "home", description = "A home of two rooms, and a scene of what is true there.")
  static final class OfHome extends Written {
    @Override
    Template files() {
      return new Template("home", List.of("home.ttl", "scene.ttl"));
    }

    @Override
    List<String> next(String where) {
      return List.of(
          "./maestro check %1$s/home.ttl --scene %1$s/scene.ttl".formatted(where),
          "./maestro run %1$s/home.ttl --scene %1$s/scene.ttl".formatted(where),
          "and in another terminal: ./maestro goal \"(nextTo Book Ada)\"",
          "What else a home can have: docs/guide-homes.md");
    }
  }

  @Command(name = "device", description = "A device of your own, in Java or in Python.")
  static final class OfDevice extends Written {
    @Option(names = "--python", description = "In Python, with the package rats.")
    private boolean python;

    @Override
    Template files() {
      return python
          ? new Template("python-device", List.of("device.py"))
          : new Template("java-device", List.of("pom.xml", "src/main/java/Bell.java"));
    }

    @Override
    List<String> next(String where) {
      String platform = "./maestro run bob --broker-port 1883";
      String goal = "and in another terminal: ./maestro goal \"(rung bell-1)\"";
      String more = "What else a device can do: docs/guide-bus.md";
      return python
          ? List.of(
              platform,
              "pip install ./rats-bridge/python",
              "python3 %s/device.py 127.0.0.1 1883 maestro".formatted(where),
              goal,
              more)
          : List.of(
              platform,
              install(),
              "mvn -f %s compile exec:java -Dexec.mainClass=Bell -Dexec.args=\"127.0.0.1 1883 maestro\""
                  .formatted(where),
              goal,
              more);
    }
  }

  @Command(name = "scenario", description = "A project with a scenario as a JUnit test.")
  static final class OfScenario extends Written {
    @Override
    Template files() {
      return new Template("scenario", List.of("pom.xml", "src/test/java/CupTest.java"));
    }

    @Override
    List<String> next(String where) {
      return List.of(
          install(),
          "mvn -f %s test".formatted(where),
          "What else a scenario can say: docs/guide-scenarios.md");
    }
  }
}
