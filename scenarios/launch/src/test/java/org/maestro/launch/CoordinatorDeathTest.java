package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BooleanSupplier;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.bench.losses.PostOffice;
import org.maestro.platform.JoinedContainer;
import org.maestro.rats.time.PacedClock;

/**
 * The coordinator's process is killed while goals run and wait, and started again with the same
 * data: all of them end, and no step is done twice.
 */
class CoordinatorDeathTest {
  private static final Duration LIMIT = Duration.ofSeconds(120);

  private final PacedClock clock = new PacedClock(1);

  @TempDir Path directory;

  @Test
  void nineGoalsEndThoughItIsKilled() throws Exception {
    killAndRestart(List.of(6, 1, 1, 1));
  }

  /** Five run, and fifty wait for one press. */
  @Test
  @Tag("full")
  void fiftyFiveGoalsEndThoughItIsKilled() throws Exception {
    killAndRestart(List.of(51, 1, 1, 1, 1));
  }

  private void killAndRestart(List<Integer> lettersByPress) throws Exception {
    try (PostOffice office = new PostOffice(lettersByPress)) {
      Path home = Files.writeString(directory.resolve("post.ttl"), office.homeText());
      List<String> ids = new ArrayList<>();
      int presses = lettersByPress.size();
      int goals = office.letters().size();
      try (JavaProcess coordinator = start(office, home)) {
        try (JoinedContainer desk = join(coordinator)) {
          awaitTrue(() -> written("\"event\":\"came\"") == presses);
          for (String letter : office.letters()) {
            desk.desk()
                .request(
                    ACLMessage.REQUEST,
                    AgentNames.COORDINATOR,
                    LIMIT,
                    reply -> accepted(reply, ids),
                    Words.content(
                        "initCNP", Words.named("goal", Words.text("(stamped " + letter + ")"))));
          }
          awaitTrue(() -> size(ids) == goals && office.atTheGate().size() == presses);
          awaitTrue(() -> states(desk, "waiting") == goals - presses);
          assertThat(states(desk, "running")).isEqualTo(presses);
        }
        coordinator.kill();
      }
      // Done while nobody listens; the others are done when the next coordinator is there.
      office.open("press-1");
      office.open("press-2");
      try (JavaProcess coordinator = start(office, home);
          JoinedContainer desk = join(coordinator)) {
        Map<String, Integer> ends = new ConcurrentHashMap<>();
        awaitTrue(() -> table(desk).size() == goals);
        for (String id : ids) {
          desk.desk()
              .request(
                  ACLMessage.REQUEST,
                  AgentNames.COORDINATOR,
                  LIMIT,
                  reply -> {
                    if (reply.getPerformative() != ACLMessage.AGREE) {
                      ends.put(id, reply.getPerformative());
                    }
                  },
                  Words.content("await", Words.named("goal", Words.name(id))));
        }
        awaitTrue(() -> office.witness().heardAgain().size() == presses);
        office.atTheGate().forEach(office::open);
        awaitTrue(() -> ends.size() == goals);

        assertThat(ends.values()).containsOnly(ACLMessage.INFORM);
        assertThat(states(desk, "achieved")).isEqualTo(goals);
        assertThat(office.stampsByLetter().values()).hasSize(goals).containsOnly(1);
        assertThat(office.startsByCall().values()).hasSize(goals).containsOnly(1);
        assertThat(office.witness().executedTwice()).isEmpty();
        // The last one's press has no other letter, so it waited at the gate.
        assertThat(story(desk, ids.get(goals - 1)))
            .contains("asks for")
            .contains("Taken up again after a restart")
            .contains("asked for again");
        assertThat(next(desk)).isEqualTo("G" + (goals + 1));
      }
    }
  }

  @AfterEach
  void stopTheClock() {
    clock.close();
  }

  private JavaProcess start(PostOffice office, Path home) throws IOException {
    Path runtime = Files.createDirectories(directory.resolve("runtime"));
    return JavaProcess.start(
        "org.maestro.launch.Maestro",
        office.platform(home, directory.resolve("data"), 0),
        Map.of("XDG_RUNTIME_DIR", runtime.toString()));
  }

  private JoinedContainer join(JavaProcess coordinator) {
    RuntimeDirectory runtime = RuntimeDirectory.at(directory.resolve("runtime").resolve("maestro"));
    awaitTrue(() -> !runtime.running().isEmpty() || !coordinator.isAlive());
    assertThat(coordinator.isAlive()).as(coordinator::errors).isTrue();
    return JoinedContainer.join(
        Optional.of(PostOffice.SITE),
        "127.0.0.1",
        runtime.running().get(0).port(),
        "desk-" + System.nanoTime(),
        clock);
  }

  /** Lines of the journal with these words. */
  private long written(String words) {
    try {
      return Files.readAllLines(directory.resolve("data").resolve("journal.jsonl")).stream()
          .filter(line -> line.contains(words))
          .count();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void accepted(ACLMessage reply, List<String> ids) {
    if (reply.getPerformative() == ACLMessage.AGREE) {
      synchronized (ids) {
        ids.add(Words.of(Words.parse(reply.getContent()).get(0)).string("goal").orElseThrow());
      }
    }
  }

  private static int size(List<String> ids) {
    synchronized (ids) {
      return ids.size();
    }
  }

  private static List<Words> table(JoinedContainer desk) {
    return Words.parse(
            desk.ask(ACLMessage.QUERY_REF, AgentNames.COORDINATOR, Words.content("query-ref"))
                .getContent())
        .stream()
        .map(Words::of)
        .toList();
  }

  private static long states(JoinedContainer desk, String state) {
    return table(desk).stream()
        .filter(goal -> goal.string("state").filter(state::equals).isPresent())
        .count();
  }

  private static String story(JoinedContainer desk, String goal) {
    return desk.ask(
            ACLMessage.REQUEST,
            AgentNames.COORDINATOR,
            Words.content("explain", Words.named("goal", Words.name(goal))))
        .getContent();
  }

  private static String next(JoinedContainer desk) {
    List<String> ids = new ArrayList<>();
    desk.desk()
        .request(
            ACLMessage.REQUEST,
            AgentNames.COORDINATOR,
            LIMIT,
            reply -> accepted(reply, ids),
            Words.content("initCNP", Words.named("goal", Words.text("(stamped letter-0-0)"))));
    awaitTrue(() -> size(ids) == 1);
    return ids.get(0);
  }

  private static void awaitTrue(BooleanSupplier condition) {
    Awaitility.await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(50))
        .atMost(LIMIT)
        .until(condition::getAsBoolean);
  }
}
