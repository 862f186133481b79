package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.language.Language;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.Situation;
import org.maestro.language.wording.AbilityWords;
import org.maestro.language.wording.DeedWords;
import org.maestro.language.wording.FactWords;
import org.maestro.language.wording.GoalWords;
import org.maestro.language.wording.SpanWords;
import org.maestro.language.wording.Wish;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** What is so, what is done for a goal and what becomes of it is told as people say it. */
class GoalWordsTest {
  private static final Home HOME = Shipped.home("evening");
  private static final Grammar GRAMMAR = Language.of(HOME, "en").grammar();

  private final FactWords facts = new FactWords(HOME, GRAMMAR, Optional.of("Dave"));
  private final DeedWords deeds = new DeedWords(HOME, GRAMMAR, Optional.of("Dave"));
  private final GoalWords words = new GoalWords(HOME, GRAMMAR, Optional.of("Dave"));

  private static Formula formula(String text) {
    return SlParser.formula(text, HOME.vocabulary()::isFluent);
  }

  private static Wish wish(Home home, String goal, int secondsAgo) {
    return new Wish(
        Optional.of(SlParser.formula(goal, home.vocabulary()::isFluent)),
        Optional.empty(),
        Optional.of("Bob"),
        Duration.ofSeconds(secondsAgo));
  }

  private static Wish wish(String goal, String by, int secondsAgo) {
    return new Wish(
        Optional.of(formula(goal)),
        Optional.empty(),
        Optional.of(by),
        Duration.ofSeconds(secondsAgo));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(= (level kitchen-lamp) 1)              | the kitchen light is on",
        "(= (level kitchen-lamp) 0)              | the kitchen light is off",
        "(= (level kitchen-lamp) 0.25)           | the level of the kitchen light is 25 percent",
        "(= (opening blinds-bed) 0)              | the bedroom's blinds are closed",
        "(and (= (level hall-lamp) 1) (= (level bed-lamp) 1)) | the hall light and the bedroom light are on",
        "(and (= (level hall-lamp) 1) (locked front-door)) | the hall light is on and the front door is locked",
        "(in glass-2 sink)                       | the glass is in the sink",
        "(nextTo cup-1 Dave)                     | the cup is next to you",
        "(not (nextTo cup-1 Rose))               | the cup is not next to Rose",
        "(exists (?x - Glass) (nextTo ?x Dave))  | a glass is next to you",
        "(forall (?x - Lamp) (= (level ?x) 0))   | every lamp is off",
        "(= (volume stereo) 30)                  | the volume of the stereo is 30",
        "(>= (illuminance kitchen) 72)           | the illuminance of the kitchen is 72 lux at least",
        "(atHome Dave)                           | you are home",
        "(atHome Rose)                           | Rose is home"
      })
  void whatIsSoHasNoIds(String fact, String told) {
    assertThat(facts.of(formula(fact))).contains(told);
  }

  @Test
  void whatHasNoWordsIsNotTold() {
    assertThat(facts.of(formula("(imply (atHome Dave) (atHome Rose))"))).isEmpty();
    assertThat(deeds.of(formula("(imply (atHome Dave) (atHome Rose))"))).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(= (level kitchen-lamp) 1)             | turn on the kitchen light | turning on the kitchen light",
        "(= (opening blinds-bed) 0)             | close the bedroom's blinds | closing the bedroom's blinds",
        "(nextTo cup-1 Dave)                    | bring the cup to you      | bringing the cup to you",
        "(exists (?x - Glass) (nextTo ?x Dave)) | bring a glass to you      | bringing a glass to you",
        "(in cup-1 ?where)                      | find the cup              | finding the cup",
        "(and (= (level hall-lamp) 1) (= (level bed-lamp) 1)) | turn on the hall light and the bedroom light | turning on the hall light and the bedroom light",
        "(= (volume stereo) 30) | see to it that the volume of the stereo is 30 | seeing to it that the volume of the stereo is 30",
        "(at \"22:00\" :every \"day\" (= (opening blinds-bed) 0)) | close the bedroom's blinds at 22:00 every day | closing the bedroom's blinds at 22:00 every day",
        "(at \"07:30\" :every \"monday friday\" (= (opening blinds-bed) 1)) | open the bedroom's blinds at 07:30 every Monday and Friday | opening the bedroom's blinds at 07:30 every Monday and Friday",
        "(at \"07:30\" :on \"Friday\" (= (opening blinds-bed) 1)) | open the bedroom's blinds at 07:30 on Friday | opening the bedroom's blinds at 07:30 on Friday",
        "(once (atHome Rose) (= (level hall-lamp) 1)) | turn on the hall light as soon as Rose is home | turning on the hall light as soon as Rose is home",
        "(whenever (atHome Rose) (= (level hall-lamp) 1)) | turn on the hall light when Rose is home | turning on the hall light when Rose is home",
        "(after 600 (= (level hall-lamp) 0)) | turn off the hall light after ten minutes | turning off the hall light after ten minutes"
      })
  void whatIsDoneIsSaidByTheConstructionsOfTheHome(String goal, String deed, String doing) {
    assertThat(deeds.of(formula(goal))).contains(deed);
    assertThat(deeds.doing(formula(goal))).contains(doing);
  }

  @Test
  void whatBecomesOfAGoalIsTold() {
    Wish wish = wish("(= (level kitchen-lamp) 1)", "Dave", 0);
    assertThat(words.accepted(wish)).isEqualTo("I will turn on the kitchen light.");
    assertThat(words.reached(wish.goal(), true)).isEqualTo("The kitchen light is on.");
    assertThat(words.reached(wish.goal(), false))
        .isEqualTo("The kitchen light is on. That is what I was told; nobody has seen it.");
    assertThat(words.failed(wish, List.of("kitchen-lamp has not answered.")))
        .isEqualTo("I could not turn on the kitchen light. The kitchen light has not answered.");
    assertThat(words.calledOff(wish)).isEqualTo("I am no longer turning on the kitchen light.");
    assertThat(words.doing(List.of(wish))).isEqualTo("I am turning on the kitchen light.");
    assertThat(words.doing(List.of())).isEqualTo("Nothing just now.");
  }

  @Test
  void whoAskedForItAndWhenIsTold() {
    Wish own = wish("(= (level kitchen-lamp) 1)", "Dave", 600);
    Wish ofTom = wish("(= (level reading-lamp) 0)", "Tom", 600);
    assertThat(words.reason(own))
        .isEqualTo("You asked me to turn on the kitchen light, ten minutes ago.");
    assertThat(words.reason(ofTom))
        .isEqualTo("Tom asked me to turn off the reading lamp, ten minutes ago.");
    assertThat(words.doer(ofTom)).isEqualTo("Tom did, ten minutes ago.");
    assertThat(words.doer(own)).isEqualTo("You did, ten minutes ago.");
    assertThat(words.which(List.of(own, ofTom)))
        .isEqualTo(
            "Which do you mean, turning on the kitchen light or turning off the reading lamp?");
    assertThat(words.which(List.of(ofTom))).isEqualTo("Do you mean turning off the reading lamp?");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "rob drives to kitchen                    | Rob drives to the kitchen.",
        "The kitchen-lamp says no: (= (level kitchen-lamp) 0) | The kitchen light says no: the kitchen light is off.",
        "37.5 lux in the livingroom (illuminance of livingroom is 37.5 lux) | 37.5 lux in the living room (illuminance of the living room is 37.5 lux).",
        "Nobody can (yet                          | Nobody can (yet."
      })
  void reportsHaveNamesInThePlaceOfIds(String report, String told) {
    assertThat(words.report(report)).isEqualTo(told);
  }

  @Test
  void aStepThatSetsANumberIsToldByWhatIsDone() {
    assertThat(words.step("kitchen-lamp", "adjustLight", "kitchen-lamp is set to 1"))
        .isEqualTo("I am turning on the kitchen light.");
    assertThat(words.step("rob", "move", "rob drives to kitchen"))
        .isEqualTo("Rob drives to the kitchen.");
  }

  @ParameterizedTest
  @CsvSource({
    "3, a few seconds",
    "20, twenty seconds",
    "50, fifty seconds",
    "75, a minute",
    "600, ten minutes",
    "3700, an hour",
    "7200, two hours",
    "260000, three days"
  })
  void timesAreSaidAsPeopleSayThem(long seconds, String said) {
    SpanWords spans = new SpanWords(GRAMMAR);
    assertThat(spans.of(Duration.ofSeconds(seconds))).isEqualTo(said);
    assertThat(spans.ago(Duration.ofSeconds(seconds)))
        .isEqualTo(seconds < 10 ? "just now" : said + " ago");
  }

  @Test
  void whatCanBeDoneIsSaidInTheWordsByWhichItIsAskedFor() {
    AbilityWords able =
        new AbilityWords(
            new Situation(
                HOME,
                SceneFacts.of(HOME, Optional.of(Shipped.scene("evening", HOME))),
                Optional.of("Dave"),
                Optional.of("kitchen"),
                Optional.empty(),
                OptionalInt.empty(),
                Discourse.NONE),
            GRAMMAR);
    List<String> present = Arrays.asList("kitchen-lamp", "hob", "bed-lamp", "rob");

    assertThat(able.of(present, Optional.of(new Term.Name("kitchen"))))
        .isEqualTo(
            "I can turn on, turn off, dim and brighten the kitchen light; turn on and turn off the hob.");
    assertThat(able.of(present, Optional.of(new Term.Name("garden"))))
        .isEqualTo("There is nothing that I can do there.");
    assertThat(able.of(present, Optional.empty()))
        .contains("turn on, turn off, dim and brighten dimmer lamps", "bring an item to a person")
        .doesNotContain("kitchen-lamp");
  }

  @Test
  void itIsToldInAnotherLanguageToo() {
    Home bob = Shipped.home("bob");
    Grammar german = Language.of(bob, "de").grammar();
    GoalWords told = new GoalWords(bob, german, Optional.of("Bob"));
    Wish lamp = wish(bob, "(= (level lamp-a1) 1)", 7_200);
    Wish cup = wish(bob, "(nextTo Cup Bob)", 0);

    assertThat(told.accepted(lamp)).isEqualTo("Ich werde Lampe A1 anmachen.");
    assertThat(told.accepted(cup)).isEqualTo("Ich werde dir die Tasse bringen.");
    assertThat(told.accepted(wish(bob, "(after 600 (= (level lamp-a1) 1))", 0)))
        .isEqualTo("Ich werde Lampe A1 anmachen in zehn Minuten.");
    assertThat(told.reached(lamp.goal(), true)).isEqualTo("Lampe A1 ist an.");
    assertThat(told.reached(cup.goal(), true)).isEqualTo("Die Tasse ist neben dir.");
    assertThat(told.doing(List.of(lamp, cup)))
        .isEqualTo("Ich bin dabei: Lampe A1 anmachen und dir die Tasse bringen.");
    assertThat(told.reason(lamp)).isEqualTo("Du batest mich: Lampe A1 anmachen; vor zwei Stunden.");
    assertThat(new FactWords(bob, german, Optional.empty()).of(formula("(= (level lamp-a1) 0.5)")))
        .contains("die Helligkeit von Lampe A1 ist 50 Prozent");
    assertThat(
            new AbilityWords(
                    new Situation(
                        bob,
                        SceneFacts.of(bob, Optional.empty()),
                        Optional.of("Bob"),
                        Optional.of("zone-a"),
                        Optional.empty(),
                        OptionalInt.empty(),
                        Discourse.NONE),
                    german)
                .of(List.of("lamp-a1", "rose"), Optional.empty()))
        .startsWith(
            "Ich kann Lampen anmachen, ausmachen, dimmen und aufdrehen; Personen Dinge bringen;");
  }
}
