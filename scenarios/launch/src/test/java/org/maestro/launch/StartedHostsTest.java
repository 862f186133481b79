package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/**
 * A platform starts the process of a host by a command that stands for ssh; the process tells how
 * it was started, is killed, and is there again with its agents (ADE, 3.2; A35, A36).
 */
@Isolated("its time is wall time, which others beside it would take")
class StartedHostsTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);

  @TempDir Path directory;

  @Test
  void aKilledProcessIsStartedAgainBySecureShellAndItsAgentIsBack() throws Exception {
    Path calls = directory.resolve("calls");
    try (JavaProcess platform = platform(secureShell(calls))) {
      until(() -> platform.output().contains(" runs: "), platform);
      until(() -> placeOf("rose").equals("attic"), platform);
      JsonNode attic = attic().orElseThrow();
      assertThat(attic.path("command").asText()).contains("container", "--name=attic");
      assertThat(Path.of(attic.path("directory").asText())).isDirectory();
      long pid = pid(attic);
      assertThat(Files.readAllLines(calls)).hasSize(1);
      assertThat(Files.readString(calls)).startsWith("pi@attic ").contains("--provides=radio");

      ProcessHandle.of(pid).orElseThrow().destroyForcibly();

      until(() -> attic().filter(again -> pid(again) != pid).isPresent(), platform);
      until(() -> placeOf("rose").equals("attic"), platform);
      assertThat(Files.readAllLines(calls)).hasSize(2);
      JavaProcess.Ended goal = maestro("goal", "(in rose zone-b)").await(LIMIT);
      assertThat(goal.output()).as(goal.errors()).contains("Reached in");
    }
  }

  private Path secureShell(Path calls) throws IOException {
    Path shell = directory.resolve("ssh");
    Files.writeString(shell, "#!/bin/sh\necho \"$@\" >> %s\nshift\nexec \"$@\"\n".formatted(calls));
    return Files.setPosixFilePermissions(shell, PosixFilePermissions.fromString("rwx------"));
  }

  private JavaProcess platform(Path shell) throws IOException {
    String bob;
    try (var home = getClass().getResourceAsStream("/homes/bob.ttl")) {
      bob = new String(home.readAllBytes(), StandardCharsets.UTF_8);
    }
    Path home =
        Files.writeString(
            directory.resolve("bob.ttl"),
            bob.replace(
                "home:rose a :MobileRobot ;",
                "home:rose a :MobileRobot ; maestro:hostNeeds \"radio\" ;"));
    ObjectMapper json = new ObjectMapper();
    List<String> command =
        List.of(
            shell.toString(),
            "pi@attic",
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1",
            "-XX:+UseSerialGC",
            "-cp",
            System.getProperty("java.class.path"),
            Maestro.class.getName(),
            "container",
            "--main={main}",
            "--name={name}",
            "--provides={provides}");
    Path hosts =
        Files.writeString(
            directory.resolve("hosts.json"),
            json.writeValueAsString(
                Map.of(
                    "hosts",
                    List.of(
                        Map.of(
                            "name", "attic", "provides", List.of("radio"), "command", command)))));
    return maestro(
        "run",
        home.toString(),
        "--scene",
        "bob-dark",
        "--port",
        "0",
        "--speed",
        "10",
        "--hosts",
        hosts.toString());
  }

  private String placeOf(String agent) {
    for (JsonNode row : table("agents")) {
      if (row.path("agent").asText().equals(agent)) {
        return row.path("container").asText();
      }
    }
    return "";
  }

  private Optional<JsonNode> attic() {
    for (JsonNode row : table("agents", "--containers")) {
      if (row.path("container").asText().equals("attic")) {
        return Optional.of(row);
      }
    }
    return Optional.empty();
  }

  private static long pid(JsonNode row) {
    return row.path("pid").asLong();
  }

  private Iterable<JsonNode> table(String... arguments) {
    String[] all = new String[arguments.length + 1];
    System.arraycopy(arguments, 0, all, 0, arguments.length);
    all[arguments.length] = "--json";
    try (JavaProcess asking = maestro(all)) {
      JsonNode answer = new ObjectMapper().readTree(asking.await(LIMIT).output());
      return answer.isEmpty() ? List.of() : answer.iterator().next();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new AssertionError("Interrupted while the platform was asked", e);
    }
  }

  private JavaProcess maestro(String... arguments) throws IOException {
    return JavaProcess.start(
        "org.maestro.launch.Maestro",
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }

  private static void until(BooleanSupplier condition, JavaProcess process) {
    Awaitility.await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(200))
        .atMost(LIMIT)
        .until(() -> condition.getAsBoolean() || !process.isAlive());
    assertThat(condition.getAsBoolean()).as(process::errors).isTrue();
  }
}
