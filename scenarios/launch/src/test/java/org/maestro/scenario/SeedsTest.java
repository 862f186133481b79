package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;

/** The job itself under ten seeds. */
class SeedsTest {

  interface Job {
    @Test
    default void bringsTheCup(Stage stage) {
      assertThat(stage.goal("(nextTo Cup Bob)")).isReached().hasCallsAtMost(16);
      assertThat(stage.world()).hasNextTo("Cup", "Bob");
    }
  }

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark", seed = 1)
  class SeedOne implements Job {}

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark", seed = 2)
  class SeedTwo implements Job {}

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark", seed = 3)
  class SeedThree implements Job {}

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark", seed = 4)
  class SeedFour implements Job {}

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark", seed = 5)
  class SeedFive implements Job {}

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark", seed = 6)
  class SeedSix implements Job {}

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark", seed = 7)
  class SeedSeven implements Job {}

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark", seed = 8)
  class SeedEight implements Job {}

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark", seed = 9)
  class SeedNine implements Job {}

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark", seed = 10)
  class SeedTen implements Job {}
}
