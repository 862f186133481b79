package org.maestro.coordination.api;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.sl.Term;

/** How people read what formulas are made of. */
class SentencesTest {

  @Test
  void aPlaceIsReadAsOneAndAnyOtherTextAsATextIsWritten() {
    assertThat(Sentences.term(new Term.Text("1.23456 -2 0.5"))).isEqualTo("(1.23 -2 0.5)");
    assertThat(Sentences.term(new Term.Text("eco"))).isEqualTo("\"eco\"");
    assertThat(Sentences.term(new Term.Text("-"))).isEqualTo("\"-\"");
  }
}
