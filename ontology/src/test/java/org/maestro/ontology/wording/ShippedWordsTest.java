package org.maestro.ontology.wording;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.home.Script;
import org.maestro.ontology.vocabulary.NameCheck;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/** What the shipped words of each language mean is said in words that the home has. */
class ShippedWordsTest {

  /** Who and what a message may speak of beside its roles. */
  private static final Map<String, List<String>> ALWAYS =
      Map.of(
          "speaker", List.of("Person"),
          "here", List.of("Zone"),
          "self", List.of("MobileRobot"),
          "agent", List.of(),
          "it", List.of());

  private static Home home(String name) {
    return new HomeLoader()
        .load(Path.of("../scenarios/assembly/src/main/resources/homes", name + ".ttl"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"evening", "bob", "household", "livingroom", "exploration"})
  void constructionsSpeakOfWhatTheHomeHas(String name) {
    Home home = home(name);

    for (Construction construction : home.wording().constructions()) {
      Map<String, List<String>> variables = new HashMap<>(ALWAYS);
      construction.roles().forEach(role -> variables.put(role.name(), types(home, role)));
      List<Formula> formulas = new ArrayList<>();
      construction.means().ifPresent(means -> collect(means.arguments(), formulas));
      construction.holdsWhen().ifPresent(formulas::add);
      boolean asks =
          construction.means().filter(means -> means.operator().equals("query-ref")).isPresent();
      formulas.forEach(
          formula ->
              assertThat(problems(home, variables, formula))
                  .as(construction.name())
                  .allMatch(problem -> asks && problem.contains("which nothing binds")));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"evening", "bob", "household", "livingroom", "exploration"})
  void statesSpeakOfWhatTheHomeHas(String name) {
    Home home = home(name);

    for (StateWord state : home.wording().states()) {
      Map<String, List<String>> it = Map.of("it", List.of(state.of()));
      Stream.concat(Stream.of(state.holdsWhen()), state.broughtAboutBy().stream())
          .forEach(formula -> assertThat(problems(home, it, formula)).as(state.name()).isEmpty());
    }
  }

  @Test
  void whatIsPerformedIsAScriptOfTheHomeWithItsArguments() {
    Home home = home("evening");
    List<Content> performed =
        home.wording().constructions().stream()
            .flatMap(construction -> construction.means().stream())
            .filter(means -> means.operator().equals("perform"))
            .toList();

    assertThat(performed).hasSizeGreaterThan(10);
    for (Content means : performed) {
      Map<String, Content.Argument> given = new HashMap<>();
      means
          .arguments()
          .forEach(
              argument -> {
                Content.Argument.Named named = (Content.Argument.Named) argument;
                given.put(named.name(), named.arguments().get(0));
              });
      Content.Argument.OfTerm named = (Content.Argument.OfTerm) given.remove("script");
      Script script = home.scripts().get(((Term.Name) named.term()).text());
      assertThat(script).as(named.toString()).isNotNull();
      assertThat(new TreeSet<>(given.keySet()))
          .as(script.name())
          .containsExactlyInAnyOrderElementsOf(
              script.parameters().stream().map(TypedVariable::name).toList());
    }
  }

  @Test
  void aHomeWithoutAppliancesHasNoWordsForThem() {
    Wording words = home("bob").wording();

    assertThat(words.constructions())
        .extracting(Construction::name)
        .contains("lightingUp", "putting", "bringingSomebody", "goingTo")
        .doesNotContain("changingTheDisc", "playingAFilm", "serving");
    assertThat(words.names()).containsKey("Lamp").doesNotContainKey("Stereo");
  }

  @Test
  void aRoleIsOneInWhicheverLanguageItIsAskedFor() {
    for (Construction construction : home("bob").wording().constructions()) {
      assertThat(construction.roles())
          .as(construction.name())
          .extracting(Construction.Role::name)
          .doesNotHaveDuplicates();
    }
    Construction.Role object =
        home("bob").wording().constructions().stream()
            .filter(construction -> construction.name().equals("lightingUp"))
            .findFirst()
            .orElseThrow()
            .roles()
            .get(0);
    assertThat(object.type()).isEqualTo("Lamp");
    assertThat(object.questions()).extracting(Said::language).containsExactlyInAnyOrder("en", "de");
  }

  private static List<String> types(Home home, Construction.Role role) {
    return home.vocabulary().classes().containsKey(role.type())
            || List.of("decimal", "duration", "string").contains(role.type())
        ? List.of(role.type().equals("duration") ? "decimal" : role.type())
        : List.of();
  }

  private static List<String> problems(
      Home home, Map<String, List<String>> variables, Formula formula) {
    List<String> problems = new ArrayList<>();
    new NameCheck(
            home.vocabulary(),
            home.individuals()::containsKey,
            (name, type) -> home.individuals().get(name).classes().contains(type),
            variables,
            NameCheck::declare,
            (problem, cure) -> problems.add(problem + "; " + cure))
        .check(goal(formula));
    return problems;
  }

  private static Formula goal(Formula formula) {
    return formula instanceof Formula.Keep keep ? keep.body() : formula;
  }

  /** All that is true or false; a number that is asked for is neither. */
  private static void collect(List<Content.Argument> arguments, List<Formula> into) {
    for (Content.Argument argument : arguments) {
      if (argument instanceof Content.Argument.OfFormula of) {
        into.add(of.formula());
      } else if (argument instanceof Content.Argument.Nested nested) {
        collect(nested.content().arguments(), into);
      } else if (argument instanceof Content.Argument.Named named
          && !named.name().equals("value")) {
        collect(named.arguments(), into);
      }
    }
  }
}
