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

  @Test
  void aNumberWithoutEndIsToldByItsPowerOfTen() {
    assertThat(Sentences.number(1e300)).isEqualTo("1.0E300");
    assertThat(Sentences.number(-2.5e15)).isEqualTo("-2.5E15");
    assertThat(Sentences.number(999_999_999_999_999.0)).isEqualTo("999999999999999");
    assertThat(Sentences.number(12.345)).isEqualTo("12.35");
    assertThat(Sentences.number(0.0125)).isEqualTo("0.013");
  }
}
