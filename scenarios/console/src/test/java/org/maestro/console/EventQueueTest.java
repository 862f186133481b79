package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.time.Duration;
import org.junit.jupiter.api.Test;

/** Who listens and does not take what is told is let go, and holds nothing of others up. */
class EventQueueTest {
  private static final int MORE_THAN_FIT = 10_000;

  @Test
  void whatIsTakenInTimeComesInOrder() throws InterruptedException {
    EventQueue queue = new EventQueue();
    for (int i = 0; i < 3; i++) {
      assertThat(queue.add("story", JsonNodeFactory.instance.numberNode(i))).isTrue();
    }

    for (int i = 0; i < 3; i++) {
      assertThat(queue.next(Duration.ZERO))
          .contains(new EventQueue.Event("story", String.valueOf(i)));
    }
    assertThat(queue.isOver()).isFalse();
  }

  @Test
  void whoTakesNothingIsLetGo() {
    EventQueue queue = new EventQueue();
    int taken = 0;
    while (taken < MORE_THAN_FIT && queue.add("facts", JsonNodeFactory.instance.nullNode())) {
      taken++;
    }

    assertThat(taken).isBetween(1, MORE_THAN_FIT - 1);
    assertThat(queue.isOver()).isTrue();
  }

  @Test
  void whatIsWorthNothingLateIsTakenAsItIsLast() throws InterruptedException {
    EventQueue queue = new EventQueue();
    queue.add("story", JsonNodeFactory.instance.numberNode(0));
    for (int i = 0; i < MORE_THAN_FIT; i++) {
      assertThat(queue.addInPlace("streams", JsonNodeFactory.instance.numberNode(i))).isTrue();
    }

    assertThat(queue.next(Duration.ZERO)).contains(new EventQueue.Event("story", "0"));
    assertThat(queue.next(Duration.ZERO))
        .contains(new EventQueue.Event("streams", String.valueOf(MORE_THAN_FIT - 1)));
    assertThat(queue.next(Duration.ZERO)).isEmpty();
  }

  @Test
  void whoHasLeftIsToldNothing() {
    EventQueue queue = new EventQueue();
    queue.end();

    assertThat(queue.add("story", JsonNodeFactory.instance.nullNode())).isFalse();
  }
}
