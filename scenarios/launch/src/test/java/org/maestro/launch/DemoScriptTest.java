package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.spi.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The first command of the README, by its script and in a process of its own, from what is compiled
 * already: it runs to its end, and says so.
 */
class DemoScriptTest {
  private static final Duration LIMIT = Duration.ofMinutes(4);
  private static final String PROGRAM = "maestro-launch-0.1.0-SNAPSHOT.jar";

  @TempDir Path checkout;

  @Test
  @Tag("full")
  void bobGetsHisCup() throws Exception {
    Path script = installed();
    Path runtime = checkout.resolve("run");
    Files.createDirectory(
        runtime,
        PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
    Path output = checkout.resolve("output");
    Path errors = checkout.resolve("errors");
    ProcessBuilder builder =
        new ProcessBuilder(script.toString(), "demo")
            .redirectOutput(output.toFile())
            .redirectError(errors.toFile())
            .redirectInput(new File("/dev/null"));
    builder.environment().put("XDG_RUNTIME_DIR", runtime.toString());
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    Process demo = builder.start();
    try {
      boolean ended = demo.waitFor(LIMIT.toMillis(), TimeUnit.MILLISECONDS);

      String said = Files.readString(output);
      assertThat(ended).as(said + Files.readString(errors)).isTrue();
      assertThat(demo.exitValue()).as(said + Files.readString(errors)).isZero();
      assertThat(said)
          .contains("Reached: in the simulated world, (nextTo Cup Bob) is true.")
          .contains("rose places Cup at Bob")
          .contains("./maestro why G1")
          .containsPattern("(?m)\\S+\\.png");
      assertThat(Files.readString(errors)).doesNotContain("Exception", "\tat ", "building");
    } finally {
      demo.descendants().forEach(ProcessHandle::destroyForcibly);
      demo.destroyForcibly().onExit().join();
    }
  }

  /** A checkout after its build: the script, the program and its libraries, and nothing newer. */
  private Path installed() throws IOException {
    Path script = Files.copy(Path.of("../../maestro"), checkout.resolve("maestro"));
    Files.setPosixFilePermissions(script, PosixFilePermissions.fromString("rwxr-xr-x"));
    Files.createFile(checkout.resolve("pom.xml"));
    Path sources = checkout.resolve("scenarios/launch/src/main");
    Files.createDirectories(sources);
    Path target = checkout.resolve("scenarios/launch/target");
    Path libraries = Files.createDirectories(target.resolve("lib"));
    int number = 0;
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
      Path part = Path.of(entry).toAbsolutePath().normalize();
      if (!Files.isDirectory(part)) {
        if (Files.exists(part)) {
          Files.createSymbolicLink(libraries.resolve(++number + "-" + part.getFileName()), part);
        }
      } else if (!part.endsWith("test-classes")) {
        boolean isProgram = part.equals(Path.of("target/classes").toAbsolutePath());
        jar(part, isProgram ? target.resolve(PROGRAM) : libraries.resolve(++number + ".jar"));
      }
    }
    assertThat(target.resolve(PROGRAM)).exists();
    return script;
  }

  private static void jar(Path classes, Path jar) {
    int code =
        ToolProvider.findFirst("jar")
            .orElseThrow()
            .run(
                System.out,
                System.err,
                List.of(
                        "--create",
                        "--no-compress",
                        "--file",
                        jar.toString(),
                        "-C",
                        classes.toString(),
                        ".")
                    .toArray(String[]::new));
    assertThat(code).isZero();
  }
}
