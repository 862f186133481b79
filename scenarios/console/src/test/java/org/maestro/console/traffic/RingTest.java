package org.maestro.console.traffic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** However much goes by, little is kept, and each keeps its number. */
class RingTest {
  @Test
  void theLatestAreKept() {
    Ring<String> ring = new Ring<>(3, 100);
    List.of("a", "b", "c", "d", "e").forEach(one -> ring.add(one, 1));

    assertThat(ring.between(0, 99)).extracting(Ring.Kept::what).containsExactly("c", "d", "e");
    assertThat(ring.between(3, 4)).extracting(Ring.Kept::number).containsExactly(4L);
    assertThat(ring.oldest()).isEqualTo(3);
    assertThat(ring.latest()).isEqualTo(5);
    assertThat(ring.find(2)).isEmpty();
    assertThat(ring.find(5)).isPresent();
  }

  @Test
  void whatIsHeavyPushesOutMore() {
    Ring<String> ring = new Ring<>(100, 10);
    ring.add("light", 4);
    ring.add("light", 4);
    ring.add("heavy", 7);
    assertThat(ring.between(0, 99)).extracting(Ring.Kept::what).containsExactly("heavy");

    ring.add("too heavy", 70);
    assertThat(ring.between(0, 99)).extracting(Ring.Kept::what).containsExactly("too heavy");
  }

  @Test
  void newsThatIsNotKeptCountsAsNews() {
    Ring<String> ring = new Ring<>(3, 10);
    ring.pass();

    assertThat(ring.latest()).isEqualTo(1);
    assertThat(ring.oldest()).isEqualTo(2);
    assertThat(ring.between(0, 1)).isEmpty();
  }
}
