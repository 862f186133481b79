package org.maestro.junit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.maestro.agents.content.AskedGoal;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.sl.SlPrinter;

/**
 * The whole story of runs of shipped homes, with bids, plans and times, byte for byte as it was
 * kept: who gives no benefit to a goal is treated as before there were benefits. A story that has
 * changed is written beside the test's results, to be read and taken over.
 */
class KeptStoriesTest {

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark")
  class InBobsFlat {
    @Test
    void theCupIsBroughtThoughItIsDark(Stage stage) throws IOException {
      Kept run = new Kept(stage);
      stage.goal("(nextTo Cup Bob)");
      run.isAsKept("bob-dark");
    }

    @Test
    void whoGoesFirstGetsTheRobotAndTheLight(Stage stage) throws IOException {
      Kept run = new Kept(stage);
      stage.begin("(keep (and (>= (illuminance zone-b) 40) (<= (illuminance zone-b) 60)))");
      stage.run(Duration.ofSeconds(20));
      Pursuit low = stage.begin(new AskedGoal("(nextTo Cup Bob)").priority(1));
      stage.run(Duration.ofMillis(500));
      Pursuit high = stage.begin(new AskedGoal("(in rose zone-a)").priority(5));
      Pursuit late = stage.begin(new AskedGoal("(in Cup zone-a)").deadline(Duration.ofMinutes(5)));
      high.await();
      low.await();
      late.await();
      stage.run(Duration.ofSeconds(20));
      run.isAsKept("bob-contention");
    }
  }

  @Nested
  @MaestroTest(home = "bob-two-robots", scene = "bob-two-robots")
  class WithTwoRobots {
    @Test
    void goalsGoOnSideBySide(Stage stage) throws IOException {
      Kept run = new Kept(stage);
      Pursuit cup = stage.begin("(nextTo Cup Bob)");
      Pursuit robot = stage.begin("(in rose zone-b)");
      Pursuit other = stage.begin(new AskedGoal("(in tim zone-a)").priority(1));
      cup.await();
      robot.await();
      other.await();
      run.isAsKept("two-robots");
    }
  }

  @Nested
  @MaestroTest(home = "arena", scene = "arena-dark")
  class InTheArena {
    @Test
    void lightIsKeptBesideAGoal(Stage stage) throws IOException {
      Kept run = new Kept(stage);
      stage.begin("(keep (>= (illuminance zone-2) 72))");
      stage.goal("(canSee ?agent GreenObject)");
      stage.run(Duration.ofMinutes(2));
      run.isAsKept("arena");
    }
  }

  private static final class Kept {
    private final List<StoryEntry> told = new CopyOnWriteArrayList<>();

    Kept(Stage stage) {
      stage.platform().onStory(told::add);
    }

    void isAsKept(String name) throws IOException {
      StringBuilder text = new StringBuilder();
      for (StoryEntry entry : told) {
        text.append(
            "%s %s s %s %s%n"
                .formatted(
                    entry.goalId(),
                    SlPrinter.print(entry.at().toMillis() / 1000.0),
                    entry.kind(),
                    entry.text()));
      }
      Path now = Path.of("target", "stories", name + ".txt");
      Files.createDirectories(now.toAbsolutePath().getParent());
      Files.writeString(now, text);
      assertThat(text.toString()).as("see " + now).isEqualTo(kept(name));
    }

    private static String kept(String name) throws IOException {
      try (InputStream file =
          KeptStoriesTest.class.getResourceAsStream("/stories/" + name + ".txt")) {
        return file == null ? "" : new String(file.readAllBytes(), StandardCharsets.UTF_8);
      }
    }
  }
}
