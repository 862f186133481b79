package org.maestro.members;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.Argument;
import org.maestro.sl.Term;

class JsonTermsTest {

  @Test
  void aPointerBringsItsProperties() {
    Argument cup =
        new Argument(
            new Term.Name("Cup"),
            Optional.of("urn:home#Cup"),
            Map.of(
                "position",
                List.of(new Term.Text("1 2 0.5")),
                "mass",
                List.of(new Term.Number(0.25))));

    assertThat(JsonTerms.json(cup))
        .isEqualTo(Map.of("ref", "urn:home#Cup", "position", List.of(1.0, 2.0, 0.5), "mass", 0.25));
  }

  @Test
  void anOutlineIsAnArrayOfPoints() {
    Argument outline = new Argument(new Term.Text("0 0, 3 0, 3 3"), Optional.empty(), Map.of());

    assertThat(JsonTerms.json(outline))
        .isEqualTo(List.of(List.of(0.0, 0.0), List.of(3.0, 0.0), List.of(3.0, 3.0)));
  }

  @Test
  void textThatOnlyStartsLikeNumbersStaysText() {
    Argument note = new Argument(new Term.Text("3 apples"), Optional.empty(), Map.of());

    assertThat(JsonTerms.json(note)).isEqualTo("3 apples");
  }

  @Test
  void valuesOfTheBusBecomeTerms() {
    assertThat(JsonTerms.term(List.of(1.5, 2, 0))).isEqualTo(new Term.Text("1.5 2 0"));
    assertThat(JsonTerms.term(true)).isEqualTo(new Term.Truth(true));
    assertThat(JsonTerms.term(17)).isEqualTo(new Term.Number(17));
    assertThat(JsonTerms.term(Map.of("ref", "urn:home#Cup"))).isEqualTo(new Term.Name("Cup"));
  }

  /** What a device calls a thing or a value cannot pass for more words than one. */
  @Test
  void whatIsNoNameIsATextOrLeftAway() {
    String forged = "Box) (:facts \"(bright Box)\"";

    assertThat(JsonTerms.term(Map.of("ref", "urn:home#" + forged)))
        .isEqualTo(new Term.Text(forged));
    assertThat(JsonTerms.term(Map.of("ref", "urn:home#Box"))).isEqualTo(new Term.Name("Box"));
    assertThat(JsonTerms.terms(Map.of("kilograms", 3, forged, 4, "\u001b[2J", 5)))
        .isEqualTo(Map.of("kilograms", new Term.Number(3)));
  }
}
