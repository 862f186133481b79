package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** Starting points run as they are written. */
@Isolated("its time is wall time, which others beside it would take")
class NewCommandTest {
  private static final Duration LIMIT = Duration.ofSeconds(90);
  private static final Path GUIDE = Path.of("..", "..", "docs", "guide-homes.md");

  @TempDir private Path directory;

  private record Said(int exitCode, String out, String err) {}

  @Test
  void theHomeIsTheOneOfTheGuideAndHasNoFault() throws IOException {
    Path where = directory.resolve("mine");
    Said said = maestro("new", "home", where.toString());
    assertThat(said.exitCode()).as(said.err()).isZero();
    assertThat(said.out()).contains("./maestro run " + where.resolve("home.ttl"));

    List<String> shown =
        Pattern.compile("(?s)```turtle\n(.*?)```")
            .matcher(Files.readString(GUIDE))
            .results()
            .map(block -> block.group(1))
            .toList();
    assertThat(Files.readString(where.resolve("home.ttl"))).isEqualTo(shown.get(0));
    assertThat(Files.readString(where.resolve("scene.ttl"))).isEqualTo(shown.get(1));
    Said checked =
        maestro(
            "check",
            where.resolve("home.ttl").toString(),
            "--scene",
            where.resolve("scene.ttl").toString());
    assertThat(checked.exitCode()).as(checked.out()).isZero();
  }

  @Test
  void theDeviceInJavaIsPlannedWith() throws Exception {
    Path where = directory.resolve("java");
    assertThat(maestro("new", "device", where.toString()).exitCode()).isZero();
    assertThat(Files.readString(where.resolve("pom.xml"))).contains(Version.number());
    Path classes = compiled(where.resolve("src/main/java/Bell.java"));

    int port = freePort();
    try (JavaProcess platform = platform(port);
        JavaProcess bell =
            JavaProcess.startWith(
                classes, "Bell", List.of("127.0.0.1", String.valueOf(port), "maestro"))) {
      assertThat(bell.isAlive()).isTrue();
      assertRung(platform);
    }
  }

  @Test
  void theDeviceInPythonIsPlannedWith() throws Exception {
    Path where = directory.resolve("python");
    assertThat(maestro("new", "device", where.toString(), "--python").exitCode()).isZero();
    assumeTrue(
        bash("python3 -c 'import paho.mqtt.client'") == 0,
        "python3 with paho-mqtt is not installed; .ci/run installs them");

    int port = freePort();
    try (JavaProcess platform = platform(port)) {
      ProcessBuilder builder =
          new ProcessBuilder(
                  "python3",
                  where.resolve("device.py").toString(),
                  "127.0.0.1",
                  String.valueOf(port),
                  "maestro")
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD);
      builder
          .environment()
          .put("PYTHONPATH", Path.of("..", "..", "rats-bridge", "python", "src").toString());
      builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
      Process device = builder.start();
      try {
        assertRung(platform);
      } finally {
        device.destroyForcibly().onExit().join();
      }
    }
  }

  @Test
  void whatIsThereIsNotWrittenOver() throws IOException {
    Files.writeString(directory.resolve("mine.ttl"), "mine");

    Said said = maestro("new", "home", directory.toString());

    assertThat(said.exitCode()).isEqualTo(2);
    assertThat(said.err()).contains("is not empty; name one that is not there yet");
    try (Stream<Path> files = Files.list(directory)) {
      assertThat(files).hasSize(1);
    }
    assertThat(maestro("new").err()).contains("Say what is to be new: home, device or scenario");
  }

  private void assertRung(JavaProcess platform) throws Exception {
    Awaitility.await()
        .atMost(LIMIT)
        .until(() -> platform.output().contains(" runs: ") || !platform.isAlive());
    Awaitility.await()
        .atMost(LIMIT)
        .until(
            () -> {
              try (JavaProcess agents = command("agents")) {
                return agents.await(LIMIT).output().contains("bell-1");
              }
            });
    try (JavaProcess goal = command("goal", "(rung bell-1)")) {
      JavaProcess.Ended ended = goal.await(LIMIT);
      assertThat(ended.exitCode()).as(ended.output() + ended.errors()).isEqualTo(4);
      assertThat(ended.output()).contains("bell-1", "Reached, but not confirmed");
    }
  }

  private JavaProcess platform(int brokerPort) throws IOException {
    return command(
        "run", "bob", "--no-sim", "--port", "0", "--broker-port", String.valueOf(brokerPort));
  }

  private JavaProcess command(String... arguments) throws IOException {
    return JavaProcess.start(
        Maestro.class.getName(),
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }

  private Path compiled(Path source) throws IOException {
    Path classes = Files.createDirectories(directory.resolve("classes"));
    List<String> arguments = new ArrayList<>(List.of("-proc:none", "-d", classes.toString()));
    arguments.addAll(List.of("-cp", System.getProperty("java.class.path"), source.toString()));
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    assertThat(
            ToolProvider.getSystemJavaCompiler()
                .run(null, said, said, arguments.toArray(String[]::new)))
        .as(said.toString(StandardCharsets.UTF_8))
        .isZero();
    return classes;
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
      return socket.getLocalPort();
    }
  }

  private static int bash(String line) throws Exception {
    return new ProcessBuilder("bash", "-c", line)
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .start()
        .waitFor();
  }

  private static Said maestro(String... arguments) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    int exitCode =
        Maestro.commandLine(new PrintStream(out, true), new PrintStream(err, true))
            .execute(arguments);
    return new Said(
        exitCode, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
  }
}
