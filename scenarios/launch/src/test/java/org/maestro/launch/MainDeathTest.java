package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.awaitility.Awaitility;
import org.awaitility.core.ConditionTimeoutException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.bench.losses.PostOffice;
import org.maestro.platform.JoinedContainer;
import org.maestro.platform.failover.LeaderLock;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.platform.jade.Sockets;
import org.maestro.rats.time.PacedClock;

/**
 * The process of the main container is killed while a goal runs; another that stands by takes over,
 * the agents of another process join it, and the goal that somebody follows is reached (ADE, 3.2;
 * A32).
 */
@Isolated("its time is wall time, which others beside it would take")
class MainDeathTest {
  private static final Duration LIMIT = Duration.ofSeconds(120);
  private static final String GOAL = "(stamped letter-0-0)";
  private static final int NOBODY_SEES_STAMPS = ExitCode.NOT_SEEN;

  private final PacedClock clock = new PacedClock(1);

  @TempDir Path directory;

  @Test
  void anotherTakesOverAndTheGoalIsReached() throws Exception {
    lost(JavaProcess::kill);
  }

  /** A frozen one keeps its lock: it is ended, and does nothing any more. */
  @Test
  @Tag("full")
  void aFrozenOneIsEndedAndTheGoalIsReached() throws Exception {
    System.out.printf("main frozen, answers again after %.2f s%n", lost(JavaProcess::freeze));
  }

  /** The lock of the one before it is let go by the system, and so is its port, not at once. */
  @Test
  void aPortThatIsLetGoLateIsWaitedFor() throws Exception {
    int port = Sockets.claim(0);
    try (PostOffice office = new PostOffice(List.of(1, 1))) {
      Path home = Files.writeString(directory.resolve("post.ttl"), office.homeText());
      Path data = Files.createDirectories(directory.resolve("data"));
      LeaderLock duty = LeaderLock.tryToTake(data).orElseThrow();
      ServerSocket holder = new ServerSocket(port, 1, InetAddress.getByName("127.0.0.1"));
      try (JavaProcess second = run(office, home, port, "--standby")) {
        until(() -> second.output().contains("Standing by"), second);
        duty.close();
        until(() -> second.output().contains("is in use still; waiting for it."), second);
        holder.close();
        until(() -> second.output().contains(" runs: "), second);
      } finally {
        duty.close();
        holder.close();
      }
    }
  }

  /** The agents know the words of the home, which the process that has joined has no file of. */
  @Test
  @Tag("full")
  void theAgentsOfAnotherProcessAreInTheYellowPagesBeforeAndAfter() throws Exception {
    int port = Sockets.claim(0);
    try (PostOffice office = new PostOffice(List.of(1, 1))) {
      Path home = Files.writeString(directory.resolve("post.ttl"), office.homeText());
      try (JavaProcess main = run(office, home, port);
          JavaProcess second = standingBy(main, office, home, port);
          JavaProcess devices =
              maestro("container", "--main", "127.0.0.1:" + port, "--name", "devices")) {
        until(() -> joinings(devices) == 1, devices);
        until(() -> isReadyIn("devices", port), devices);
        main.kill();
        until(() -> joinings(devices) == 2, devices);
        until(() -> isReadyIn("devices", port), second);
      }
    }
  }

  /** What is lost, while the agent at work lives in a process that has joined. */
  private enum Lost {
    KILLED,
    FROZEN,
    KILLED_WITH_THE_JOINED
  }

  /**
   * The agent that has the order is in a process of its own, which joins whoever takes over, or is
   * no more: the order goes on, and is not carried out twice, whoever's the agent is then.
   */
  @ParameterizedTest
  @EnumSource
  @Tag("full")
  void theGoalIsReachedThoughTheAgentAtWorkIsInAnotherProcess(Lost lost) throws Exception {
    int port = Sockets.claim(0);
    try (PostOffice office = new PostOffice(List.of(1, 1))) {
      Path home = Files.writeString(directory.resolve("post.ttl"), office.homeText());
      try (JavaProcess main = run(office, home, port);
          JavaProcess second = standingBy(main, office, home, port);
          JavaProcess devices =
              maestro("container", "--main", "127.0.0.1:" + port, "--name", "devices")) {
        until(() -> joinings(devices) == 1, devices);
        until(() -> isReadyIn("devices", port), devices);
        try (JavaProcess goal = maestro("goal", GOAL, "--main", "127.0.0.1:" + port)) {
          until(() -> office.atTheGate().size() == 1, goal);
          switch (lost) {
            case KILLED -> main.kill();
            case FROZEN -> main.freeze();
            case KILLED_WITH_THE_JOINED -> {
              devices.kill();
              main.kill();
            }
          }
          until(() -> goal.output().contains("one answers there again"), goal);
          if (lost != Lost.KILLED_WITH_THE_JOINED) {
            until(() -> joinings(devices) == 2, devices);
          }
          office.open("press-0");
          assertThat(goal.await(LIMIT).exitCode())
              .as(() -> told(Map.of("goal", goal, "second", second, "devices", devices)))
              .isEqualTo(NOBODY_SEES_STAMPS);
        }
        assertThat(office.stampsByLetter()).containsEntry("letter-0-0", 1);
        assertThat(office.startsByCall()).as("the one order went on").hasSize(1);
        assertThat(office.witness().executedTwice()).isEmpty();
      }
    }
  }

  private String told(Map<String, JavaProcess> processes) {
    StringBuilder told = new StringBuilder();
    processes.forEach(
        (name, process) ->
            told.append("%s said:%n%s%n%s%n".formatted(name, process.output(), process.errors())));
    return told + logs();
  }

  /** All processes of a test write to one log, which says why what failed did. */
  private String logs() {
    try (Stream<Path> files = Files.walk(directory)) {
      StringBuilder logs = new StringBuilder();
      for (Path log : files.filter(file -> file.toString().endsWith(".log")).toList()) {
        logs.append("%s:%n%s%n".formatted(log, Files.readString(log)));
      }
      return logs.toString();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** How often it has become the home of the agents. */
  private static long joinings(JavaProcess devices) {
    return devices
        .output()
        .lines()
        .filter(line -> line.startsWith("The container devices runs here, with press-"))
        .count();
  }

  /** Whether the press's agent lives there, has its member, and is in the yellow pages. */
  private boolean isReadyIn(String container, int port) {
    List<Words> tables = new ArrayList<>();
    boolean isThere =
        isAnswered(
            port,
            AgentNames.SUPERVISOR,
            answer ->
                tables.addAll(Words.parse(answer.getContent()).stream().map(Words::of).toList()));
    return isThere
        && tables.stream()
            .filter(line -> line.string("agent").equals(Optional.of("press-0")))
            .anyMatch(
                line ->
                    line.string("container").equals(Optional.of(container))
                        && line.string("phase").equals(Optional.of("ready"))
                        && line.strings("services").stream().anyMatch("stamp"::equals));
  }

  /** On a machine without other work. */
  @Tag("full")
  @RepeatedTest(10)
  void asOftenAsItHappens() throws Exception {
    double seconds = lost(JavaProcess::kill);
    System.out.printf("main killed, answers again after %.2f s%n", seconds);
    assertThat(seconds).isLessThan(5);
  }

  private double lost(Consumer<JavaProcess> loss) throws Exception {
    int port = Sockets.claim(0);
    try (PostOffice office = new PostOffice(List.of(1, 1))) {
      Path home = Files.writeString(directory.resolve("post.ttl"), office.homeText());
      try (JavaProcess main = run(office, home, port);
          JavaProcess second = standingBy(main, office, home, port)) {
        double seconds;
        try (JavaProcess goal = maestro("goal", GOAL, "--main", "127.0.0.1:" + port)) {
          until(() -> office.atTheGate().size() == 1, goal);
          loss.accept(main);
          seconds = secondsUntilItAnswers(second, port);
          until(() -> goal.output().contains("one answers there again"), goal);
          office.open("press-0");
          assertThat(goal.await(LIMIT).exitCode())
              .as(() -> told(Map.of("goal", goal, "second", second)))
              .isEqualTo(NOBODY_SEES_STAMPS);
        }
        assertThat(main.isAlive()).isFalse();
        assertThat(second.output()).contains("this process takes over");
        assertThat(office.stampsByLetter()).containsEntry("letter-0-0", 1);
        assertThat(office.witness().executedTwice()).isEmpty();
        return seconds;
      }
    }
  }

  /** Once the first one has the duty: whoever comes first gets it. */
  private JavaProcess standingBy(JavaProcess main, PostOffice office, Path home, int port)
      throws IOException {
    until(() -> main.output().contains("runs: "), main);
    JavaProcess second = run(office, home, port, "--standby");
    until(() -> second.output().contains("Standing by"), second);
    return second;
  }

  /** JADE would keep in this process what it heard from a platform that is only half there. */
  private double secondsUntilItAnswers(JavaProcess second, int port) {
    long lost = System.nanoTime();
    until(() -> second.output().contains(" runs: "), second);
    while (!isAnswered(port, AgentNames.COORDINATOR, answer -> {})) {
      assertThat(System.nanoTime() - lost).isLessThan(LIMIT.toNanos());
    }
    return (System.nanoTime() - lost) / 1e9;
  }

  /** Asks an agent for what it has, from a container that joins for that. */
  private boolean isAnswered(int port, String agent, Consumer<ACLMessage> told) {
    try (JoinedContainer desk =
        JoinedContainer.join(
            Optional.of(PostOffice.SITE), "127.0.0.1", port, "desk-" + System.nanoTime(), clock)) {
      ACLMessage answer = desk.ask(ACLMessage.QUERY_REF, agent, Words.content("query-ref"));
      if (answer.getPerformative() != ACLMessage.INFORM) {
        return false;
      }
      told.accept(answer);
      return true;
    } catch (PlatformStartException e) {
      return false;
    }
  }

  private JavaProcess run(PostOffice office, Path home, int port, String... more)
      throws IOException {
    List<String> arguments =
        new ArrayList<>(office.platform(home, directory.resolve("data"), port));
    arguments.addAll(List.of(more));
    return maestro(arguments.toArray(String[]::new));
  }

  private JavaProcess maestro(String... arguments) throws IOException {
    Path runtime = Files.createDirectories(directory.resolve("runtime"));
    return JavaProcess.startLogging(
        "org.maestro.launch.Maestro",
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", runtime.toString()));
  }

  @AfterEach
  void stopTheClock() {
    clock.close();
  }

  private void until(BooleanSupplier condition, JavaProcess process) {
    AtomicBoolean holds = new AtomicBoolean();
    try {
      Awaitility.await()
          .pollDelay(Duration.ZERO)
          .pollInterval(Duration.ofMillis(20))
          .atMost(LIMIT)
          .until(
              () -> {
                holds.set(condition.getAsBoolean());
                return holds.get() || !process.isAlive();
              });
    } catch (ConditionTimeoutException e) {
      assertThat(e).as(() -> told(Map.of("process", process))).isNull();
    }
    assertThat(holds).as(() -> told(Map.of("process", process))).isTrue();
  }
}
