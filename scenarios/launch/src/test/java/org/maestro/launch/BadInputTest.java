package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.assertj.core.api.AbstractStringAssert;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the command line says and does when it cannot do what it was asked: whole processes. */
class BadInputTest {

  private static final Duration LIMIT = Duration.ofSeconds(90);

  @TempDir private Path directory;

  @Test
  void aHomeWithAFaultIsToldWithItsLine() throws Exception {
    String faulty;
    try (var home = getClass().getResourceAsStream("/homes/bob.ttl")) {
      faulty =
          new String(home.readAllBytes(), StandardCharsets.UTF_8)
              .replaceFirst("maestro:outline \"[^\"]*\"", "maestro:outline \"0 0, 3\"");
    }
    Path file = Files.writeString(directory.resolve("faulty.ttl"), faulty);

    JavaProcess.Ended run = maestro("run", file.toString(), "--scene", "bob-dark", "--port", "0");
    assertThat(run.exitCode()).isEqualTo(2);
    assertOneSentence(run).contains("faulty.ttl").contains("outline");

    JavaProcess.Ended check = maestro("check", file.toString());
    assertThat(check.exitCode()).isEqualTo(1);
    assertThat(check.output()).contains("outline").contains("1 fault");
    assertThat(check.errors()).isEmpty();
  }

  @Test
  void aHomeThatIsNotThereIsNamed() throws Exception {
    JavaProcess.Ended ended = maestro("run", "nowhere.ttl", "--port", "0");

    assertThat(ended.exitCode()).isEqualTo(2);
    assertOneSentence(ended).contains("nowhere.ttl");
  }

  /** A name that would steer the terminal is shown: by the whole program, not only by its parts. */
  @Test
  void aNameWithControlCharactersIsShownAndNotObeyed() throws Exception {
    JavaProcess.Ended ended = maestro("check", "no\u001b[31mwhere.ttl");

    assertThat(ended.exitCode()).isEqualTo(2);
    assertThat(ended.errors()).contains("no\\u001b[31mwhere.ttl").doesNotContain("\u001b");
  }

  @Test
  void anUnknownCommandIsToldTheNearest() throws Exception {
    JavaProcess.Ended ended = maestro("demmo");

    assertThat(ended.exitCode()).isEqualTo(2);
    assertThat(ended.errors()).contains("demmo").contains("demo");
    assertNoTrace(ended);
  }

  @Test
  void aBusyPortIsNamed() throws Exception {
    try (ServerSocket busy = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
      JavaProcess.Ended ended =
          maestro("run", "bob", "--port", String.valueOf(busy.getLocalPort()));

      assertThat(ended.exitCode()).isEqualTo(3);
      assertOneSentence(ended).contains(String.valueOf(busy.getLocalPort())).contains("--port");
    }
  }

  @Test
  void aGuiWithoutDisplayIsRefused() throws Exception {
    JavaProcess.Ended ended = maestro("run", "bob", "--port", "0", "--gui");

    assertThat(ended.exitCode()).isEqualTo(3);
    assertOneSentence(ended).contains("display");
  }

  @Test
  void aBrokerThatDoesNotAnswerIsNamed() throws Exception {
    String broker = "tcp://127.0.0.1:" + deadPort();
    JavaProcess.Ended ended = maestro("run", "bob", "--port", "0", "--broker", broker);

    assertThat(ended.exitCode()).isEqualTo(3);
    assertOneSentence(ended).contains(broker);
  }

  @Test
  void withoutAPlatformACommandSaysHowToStartOne() throws Exception {
    JavaProcess.Ended ended = maestro("goal", "(nextTo Cup Bob)");

    assertThat(ended.exitCode()).isEqualTo(3);
    assertOneSentence(ended).contains("./maestro run");
  }

  @Test
  void aContainerWithoutPlatformIsTold() throws Exception {
    String main = "127.0.0.1:" + deadPort();
    JavaProcess.Ended ended = maestro("container", "--main", main, "--name", "lights");

    assertThat(ended.exitCode()).isEqualTo(3);
    assertOneSentence(ended).contains(main);
  }

  @Test
  void aSecondPlatformOnThePortAndUnknownContainersAreRefused() throws Exception {
    String port = String.valueOf(deadPort());
    try (JavaProcess first = start("run", "bob", "--port", port)) {
      awaitOutput(first, "The platform maestro runs");

      JavaProcess.Ended second = maestro("run", "bob", "--port", port, "--name", "second");
      assertThat(second.exitCode()).isEqualTo(3);
      assertOneSentence(second).contains(port);

      JavaProcess.Ended sameName = maestro("run", "bob", "--port", "0");
      assertThat(sameName.exitCode()).isEqualTo(3);
      assertOneSentence(sameName).contains("maestro runs already");

      JavaProcess.Ended container =
          maestro("container", "--main", "127.0.0.1:" + port, "--name", "My fridges");
      assertThat(container.exitCode()).isEqualTo(2);
      assertOneSentence(container).contains("My fridges").contains("hyphens");

      JavaProcess.Ended move =
          maestro("agent", "move", "lamp-b1", "--to", "fridges", "--main", "127.0.0.1:" + port);
      assertThat(move.exitCode()).isEqualTo(2);
      assertOneSentence(move).contains("no container fridges").contains("lights");

      assertThat(first.isAlive()).isTrue();
    }
  }

  private JavaProcess start(String... arguments) throws IOException {
    return JavaProcess.start(
        Maestro.class.getName(),
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", directory.toString(), "DISPLAY", ""));
  }

  private JavaProcess.Ended maestro(String... arguments) throws Exception {
    try (JavaProcess process = start(arguments)) {
      return process.await(LIMIT);
    }
  }

  private static void awaitOutput(JavaProcess process, String expected) throws Exception {
    long end = System.nanoTime() + LIMIT.toNanos();
    while (!process.output().contains(expected)) {
      assertThat(System.nanoTime()).as("still waiting for: " + expected).isLessThan(end);
      assertThat(process.isAlive()).isTrue();
      LockSupport.parkNanos(20_000_000);
    }
  }

  private static AbstractStringAssert<?> assertOneSentence(JavaProcess.Ended ended) {
    assertNoTrace(ended);
    assertThat(ended.output()).isEmpty();
    assertThat(ended.errors().lines()).as(ended.errors()).hasSize(1);
    return assertThat(ended.errors()).startsWith("maestro: ");
  }

  private static void assertNoTrace(JavaProcess.Ended ended) {
    assertThat(Stream.of(ended.output(), ended.errors()))
        .noneMatch(text -> text.contains("Exception") || text.contains("\tat "));
  }

  private static int deadPort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
      return socket.getLocalPort();
    }
  }
}
