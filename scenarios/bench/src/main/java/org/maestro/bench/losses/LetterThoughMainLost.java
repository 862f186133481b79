package org.maestro.bench.losses;

import jade.lang.acl.ACLMessage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.bench.MaestroProcess;
import org.maestro.bench.Waiting;
import org.maestro.bench.losses.LossesBench.Figure;
import org.maestro.platform.JoinedContainer;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.platform.jade.Sockets;
import org.maestro.rats.time.PacedClock;

/**
 * A letter is being stamped when the platform's process is lost; another stands by, and the goal
 * that a person follows has to be reached. For one thread.
 */
final class LetterThoughMainLost {
  /** The exit code of a goal that is reached as far as its doer says: nobody looks at stamps. */
  private static final int REACHED_UNSEEN = 4;

  private static final Duration LIMIT = Duration.ofSeconds(90);
  private static final String LETTER = "letter-0-0";
  private static final String PRESS = "press-0";

  private final Loss loss;

  LetterThoughMainLost(Loss loss) {
    this.loss = loss;
  }

  /**
   * @throws IllegalStateException when what has to be is not so
   */
  Map<Figure, Double> run() {
    Waiting.formerPlatformsHaveEnded();
    Path directory = temporary();
    int port = Sockets.claim(0);
    List<String> goal = List.of("goal", "(stamped " + LETTER + ")", "--main", "127.0.0.1:" + port);
    try (PostOffice office = new PostOffice(List.of(1, 1));
        MaestroProcess main = platform(office, directory, port, List.of())) {
      main.awaitSaying("runs: ");
      try (MaestroProcess second = platform(office, directory, port, List.of("--standby"))) {
        second.awaitSaying("Standing by");
        try (MaestroProcess following = MaestroProcess.start(List.of(), goal)) {
          Waiting.until(() -> office.atTheGate().contains(PRESS), "the press is at work");
          if (loss == Loss.FROZEN_MAIN) {
            main.freeze();
          } else {
            main.kill();
          }
          double answered = secondsUntilItAnswers(second, port);
          following.awaitSaying("one answers there again");
          office.open(PRESS);
          require(following.awaitEnd(LIMIT) == REACHED_UNSEEN, "the goal is reached");
          require(!main.isAlive(), "the first process has ended");
          require(office.stampsByLetter().getOrDefault(LETTER, 0) == 1, "it is stamped once");
          require(office.witness().executedTwice().isEmpty(), "no call is executed twice");
          return Map.of(Figure.ANSWERED, answered);
        }
      }
    } finally {
      remove(directory);
    }
  }

  private void require(boolean isSo, String what) {
    if (!isSo) {
      throw new IllegalStateException(
          "Lost was %s, and it is not so that %s.".formatted(loss.inWords(), what));
    }
  }

  private static MaestroProcess platform(
      PostOffice office, Path directory, int port, List<String> more) {
    try {
      Path home = Files.writeString(directory.resolve("post.ttl"), office.homeText());
      List<String> arguments =
          new ArrayList<>(office.platform(home, directory.resolve("data"), port));
      arguments.addAll(more);
      return MaestroProcess.start(List.of(), arguments);
    } catch (IOException e) {
      throw new UncheckedIOException("The home of the benchmark cannot be written.", e);
    }
  }

  /** JADE would keep in this process what it heard from a platform that is only half there. */
  private static double secondsUntilItAnswers(MaestroProcess second, int port) {
    long lost = System.nanoTime();
    second.awaitSaying(" runs: ");
    try (PacedClock clock = new PacedClock(1)) {
      Waiting.until(() -> answers(port, clock), "the platform answers again");
      return Waiting.secondsSince(lost);
    }
  }

  private static boolean answers(int port, PacedClock clock) {
    try (JoinedContainer desk =
        JoinedContainer.join(
            Optional.of(PostOffice.SITE), "127.0.0.1", port, "desk-" + System.nanoTime(), clock)) {
      return desk.ask(ACLMessage.QUERY_REF, AgentNames.COORDINATOR, Words.content("query-ref"))
              .getPerformative()
          == ACLMessage.INFORM;
    } catch (PlatformStartException e) {
      return false;
    }
  }

  private static Path temporary() {
    try {
      return Files.createTempDirectory("maestro-losses");
    } catch (IOException e) {
      throw new UncheckedIOException("No temporary directory can be made.", e);
    }
  }

  private static void remove(Path directory) {
    try (var files = Files.walk(directory)) {
      files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
    } catch (IOException e) {
      throw new UncheckedIOException("Cannot clean up " + directory, e);
    }
  }
}
