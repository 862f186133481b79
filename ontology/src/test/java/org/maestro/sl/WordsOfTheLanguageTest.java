package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Numbers, names and strings: which is which, and how each is written. */
class WordsOfTheLanguageTest {

  @ParameterizedTest
  @CsvSource({
    "17,17",
    "1.,1",
    ".5,0.5",
    "-.5,-0.5",
    "+5,5",
    "1.25,1.25",
    "1e3,1000",
    "1E-3,0.001",
    "2.5e+2,250",
    "1.e2,100",
    "007,7"
  })
  void readsANumber(String text, double value) {
    assertThat(SlParser.term(text)).isEqualTo(new Term.Number(value));
  }

  /** Some of them are numbers elsewhere. */
  @ParameterizedTest
  @CsvSource({
    "3d",
    "1f",
    "1e",
    "1E+",
    "0x1p3",
    "NaN",
    "Infinity",
    "1.5.2",
    "1-2",
    "1e5e5",
    "_private",
    "Ⅷ",
    "½",
    "zone-b",
    "a@b.c"
  })
  void readsAName(String text) {
    assertThat(SlParser.term(text)).isEqualTo(new Term.Name(text));
  }

  @ParameterizedTest
  @CsvSource({
    "0,0",
    "-0.0,-0",
    "17,17",
    "-17,-17",
    "0.25,0.25",
    "12345678.25,12345678.25",
    "0.0002,0.0002",
    "0.000001,0.000001",
    "0.00000095,9.5E-7",
    "999999999999999,999999999999999",
    "1e15,1.0E15",
    "-1e15,-1.0E15",
    "1.5e20,1.5E20"
  })
  void writesANumberShortest(double value, String text) {
    assertThat(SlPrinter.print(value)).isEqualTo(text);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "\"say \\\"yes\\\"\" | say \"yes\"",
        "\"C:\\\\n\" | C:\\n",
        "\"\\\\\\\"\" | \\\"",
        "\"(in Cup a) ; ?x\" | (in Cup a) ; ?x",
      })
  void readsAStringAndWritesItTheSame(String text, String value) {
    assertThat(SlParser.term(text)).isEqualTo(new Term.Text(value));
    assertThat(SlPrinter.print(new Term.Text(value))).isEqualTo(text);
  }

  @Test
  void blanksMeanNothing() {
    assertThat(SlParser.formula("\n ( and\t( in Cup  a ) (b ) ) \n"))
        .isEqualTo(SlParser.formula("(and (in Cup a) (b))"));
  }

  @Property
  void whatIsMeantAsANameIsReadAsItWasGiven(@ForAll("strangers") String text) {
    Term named = Term.named(text);
    assertThat(SlParser.term(SlPrinter.print(named))).isEqualTo(named);
  }

  @Test
  void onlyWhatCanBeReadAsANameIsOne() {
    assertThat(Term.named("Ⅷ")).isEqualTo(new Term.Name("Ⅷ"));
    assertThat(Term.named("007")).isEqualTo(new Term.Text("007"));
    assertThat(Term.named("")).isEqualTo(new Term.Text(""));
    assertThat(Term.named("true")).isEqualTo(new Term.Name("true"));
  }

  @Test
  void aVariableCanBeCalledByANumber() {
    assertThat(SlParser.term("?17")).isEqualTo(new Term.Variable("17"));
    assertThat(Term.Variable.isName("17")).isTrue();
    assertThat(Term.Variable.isName("a b")).isFalse();
    assertThat(Term.Variable.isName("")).isFalse();
  }

  @Test
  void onlyAVariableIsNotGround() {
    assertThat(SlParser.term("?x").isGround()).isFalse();
    assertThat(SlParser.term("x").isGround()).isTrue();
    assertThat(new Formula.Atom("in", List.of()).isGround()).isTrue();
    assertThat(((Formula.Atom) SlParser.formula("(in Cup ?x)")).isGround()).isFalse();
    assertThat(((Formula.Atom) SlParser.formula("(in Cup a)")).isGround()).isTrue();
  }

  @Provide
  Arbitrary<String> strangers() {
    return Arbitraries.oneOf(
            Arbitraries.strings().ofMaxLength(6),
            Arbitraries.strings().withChars("01e.+-_aⅧ½?:\"\\<>=").ofMaxLength(6))
        .filter(text -> !text.equals("true") && !text.equals("false"));
  }
}
