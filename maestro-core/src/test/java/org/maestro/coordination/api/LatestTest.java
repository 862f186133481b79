package org.maestro.coordination.api;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class LatestTest {

  @Test
  void keepsTheLatestThatFitsAndTheNewestInAnyCase() {
    Latest<String> latest = new Latest<>(10, String::length);
    latest.put("G1", "aaaa");
    latest.put("G2", "bbbb");
    latest.put("G3", "cc");
    assertThat(latest.ids()).containsExactly("G1", "G2", "G3");

    latest.put("G1", "a");
    latest.put("G4", "ddd");
    assertThat(latest.ids()).as("what is put again is new").containsExactly("G2", "G3", "G1", "G4");

    latest.put("G5", "eeee");
    assertThat(latest.values()).containsExactly("cc", "a", "ddd", "eeee");
    latest.put("G6", "more than all together may be");
    assertThat(latest.ids()).containsExactly("G6");
    assertThat(latest.find("G5")).isEmpty();
  }
}
