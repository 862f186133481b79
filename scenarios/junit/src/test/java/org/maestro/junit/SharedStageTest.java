package org.maestro.junit;

import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;

@Shared
@MaestroTest(home = "bob", scene = "bob-lit")
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class SharedStageTest {

  @BeforeAll
  static void theStageIsThereBeforeTheTests(Stage stage) {
    assertThat(stage.world()).hasApart("Cup", "Bob");
  }

  @Test
  @Order(1)
  void theFirstBringsTheCup(Stage stage) {
    assertThat(stage.goal("(nextTo Cup Bob)")).isReached();
  }

  @Test
  @Order(2)
  void theSecondFindsWhatTheFirstLeft(Stage stage) {
    assertThat(stage.world()).hasNextTo("Cup", "Bob");
    assertThat(stage.goal("(nextTo Cup Bob)")).isReached().hasCalls(0);
  }
}
