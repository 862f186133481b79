package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Facts are kept in plain words: what is derived from them is spelled out. */
class UnfoldingTest {
  private static final String LINKED = "(or (side a b) (side b a))";

  @Test
  void derivedWordsAreSpelledOutWithTheirArguments() {
    assertThat(conjuncts("(linked a b)")).containsExactly(LINKED);
  }

  @Test
  void partsThatAllHaveToHoldStandAlone() {
    assertThat(conjuncts("(and (linked a b) (and (in Cup a) (in Bob b)))"))
        .containsExactly(LINKED, "(in Cup a)", "(in Bob b)");
    assertThat(conjuncts("(keep (and (in Cup a) (linked a b)))"))
        .containsExactly("(in Cup a)", LINKED);
  }

  @Test
  void partsOfADefinitionThatAllHaveToHoldStandAloneToo() {
    assertThat(conjuncts("(both a b)")).containsExactly(LINKED, "(open a)");
  }

  @Test
  void valuesTakeThePlaceOfVariables() {
    Map<String, Term> bindings = Map.of("from", new Term.Name("a"), "to", new Term.Name("b"));

    assertThat(
            unfolding().conjuncts(SlParser.formula("(linked ?from ?to)"), bindings).stream()
                .map(SlPrinter::print))
        .containsExactly(LINKED);
  }

  @Test
  void itGoesIntoEveryKindOfFormula() {
    assertThat(conjuncts("(not (linked a b))")).containsExactly("(not " + LINKED + ")");
    assertThat(conjuncts("(or (in Cup a) (linked a b))"))
        .containsExactly("(or (in Cup a) " + LINKED + ")");
    assertThat(conjuncts("(imply (linked a b) (linked a b))"))
        .containsExactly("(imply " + LINKED + " " + LINKED + ")");
    assertThat(conjuncts("(exists (?x) (linked a ?x))"))
        .containsExactly("(exists (?x) (or (side a ?x) (side ?x a)))");
    assertThat(conjuncts("(forall (?x) (linked a ?x))"))
        .containsExactly("(forall (?x) (or (side a ?x) (side ?x a)))");
  }

  @Test
  void whatIsNotDerivedStaysAsItIs() {
    for (String plain : List.of("(side a b)", "(>= (lux a) 3)", "(unknown (linked a b))")) {
      assertThat(conjuncts(plain)).containsExactly(plain);
    }
    assertThat(conjuncts("(linked a)"))
        .as("another number of arguments")
        .containsExactly("(linked a)");
  }

  @Test
  void aWordThatIsDerivedFromItselfIsSpelledOutOnce() {
    assertThat(conjuncts("(reachable a b)"))
        .containsExactly("(or (side a b) (exists (?c) (and (side a ?c) (reachable ?c b))))");
  }

  private static List<String> conjuncts(String formula) {
    return unfolding().conjuncts(SlParser.formula(formula, "lux"::equals), Map.of()).stream()
        .map(SlPrinter::print)
        .toList();
  }

  private static Unfolding unfolding() {
    Map<String, PredicateDeclaration> predicates = new TreeMap<>();
    declare(predicates, "side", "");
    declare(predicates, "linked", "(or (side ?x ?y) (side ?y ?x))");
    declare(predicates, "both", "(and (linked ?x ?y) (open ?x))");
    declare(
        predicates,
        "reachable",
        "(or (side ?x ?y) (exists (?c) (and (side ?x ?c) (reachable ?c ?y))))");
    return new Unfolding(new Vocabulary(Map.of(), predicates, Map.of()));
  }

  private static void declare(
      Map<String, PredicateDeclaration> predicates, String name, String derivedWhen) {
    predicates.put(
        name,
        new PredicateDeclaration(
            name,
            "https://example.org/words#" + name,
            name,
            List.of(SlParser.variable("?x"), SlParser.variable("?y")),
            false,
            false,
            false,
            false,
            Optional.empty(),
            Map.of(),
            Optional.of(derivedWhen).filter(text -> !text.isEmpty()).map(SlParser::formula),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            OptionalDouble.empty(),
            Optional.empty()));
  }
}
