import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;

/** A scenario of your own: a home, what is true there, and what is to come of it. */
@MaestroTest(home = "bob", scene = "bob-dark")
class CupTest {
  @Test
  void theCupComesToBob(Stage stage) {
    assertThat(stage.goal("(nextTo Cup Bob)")).isReached().isConfirmed();
    assertThat(stage.world()).hasNextTo("Cup", "Bob");
  }
}
