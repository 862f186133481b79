package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.sl.SlParser;

/** Whose facts are told to whom (ADE, 4.1; A30, A57), as a home states it. */
class PrivateWordsTest {
  private static final String PRIVATE =
      """
      :prefers maestro:private true .
      home:age a maestro:Fluent ; maestro:arguments ( "?p - Person" ) ; maestro:private true .
      home:likesNews a maestro:Predicate ; maestro:arguments ( "?p - Preference" ) ;
        maestro:derivedWhen "(exists (?s - Show) (prefers ?p ?s))" .
      home:pleased a maestro:Predicate ; maestro:arguments ( "?p - Preference" ) ;
        maestro:derivedWhen "(likesNews ?p)" .
      """;
  private static String livingroom;

  @BeforeAll
  static void read() throws IOException {
    livingroom =
        Files.readString(Path.of("../scenarios/assembly/src/main/resources/homes/livingroom.ttl"))
            .replaceAll("(?m)^.*maestro:private.*$", "");
  }

  private static Home home(String more) {
    return new HomeLoader().load(livingroom + more, "livingroom.ttl");
  }

  private static String fault(String more) {
    return catchThrowableOfType(HomeFaultException.class, () -> home(more)).getMessage();
  }

  private static ReadingRights rights(String permissions, String caller) {
    return PrivateWords.of(home(PRIVATE + permissions)).of(Set.of(caller), false);
  }

  @Test
  void whereNothingIsPrivateEverybodyReadsEverything() {
    PrivateWords words = PrivateWords.of(home(""));
    assertThat(words.all()).isEmpty();
    assertThat(words.of(Set.of("anybody"), false).areWhole()).isTrue();
  }

  @Test
  void whatFollowsFromAPrivateWordIsPrivateToo() {
    assertThat(PrivateWords.of(home(PRIVATE)).all())
        .containsExactlyInAnyOrder("prefers", "age", "likesNews", "pleased");
  }

  @Test
  void whatAGoalUsesIsWhatItSpeaksOfAndWhatItsScriptsReadOrState() {
    PrivateWords words =
        PrivateWords.of(
            home(
                PRIVATE
                    + """
                    home:outer a maestro:Script ; maestro:arguments () ;
                      maestro:body "(try (run inner) (finally (wait 1)))" .
                    home:inner a maestro:Script ; maestro:arguments () ;
                      maestro:body "(let ?s (one (?s - Show) (prefers dave-evenings ?s)) (assert (assign (age Dave) 7)))" .
                    home:harmless a maestro:Script ; maestro:arguments () ; maestro:body "(wait 1)" .
                    """));

    assertThat(words.usedFor(SlParser.formula("(outer)"))).containsExactly("age", "prefers");
    assertThat(words.usedFor(SlParser.formula("(at \"18:00\" (inner))")))
        .containsExactly("age", "prefers");
    assertThat(words.usedFor(SlParser.formula("(keep (not (likesNews dave-evenings)))")))
        .containsExactly("likesNews");
    assertThat(words.usedFor(SlParser.formula("(harmless)"))).isEmpty();
    assertThat(words.usedFor(SlParser.formula("(harmless)"), SlParser.expression("(age Dave)")))
        .containsExactly("age");
  }

  @Test
  void aQuestionInPrivateWordsIsRefusedInOneSentenceHoweverItHidesThem() {
    ReadingRights rights = rights("", "thief");
    for (String question :
        new String[] {
          "(prefers dave-evenings ?show)",
          "(not (prefers dave-evenings Opera))",
          "(exists (?p - Preference) (and (preferenceOf ?p Dave) (prefers ?p ?show)))",
          "(forall (?p - Preference) (or (preferenceOf ?p Eve) (prefers ?p Opera)))",
          "(unknown (prefers dave-evenings Opera))"
        }) {
      assertThat(rights.objection(SlParser.formula(question)))
          .as(question)
          .contains(
              "prefers is private in this home, and no maestro:Permission lets thief read it;"
                  + " who keeps the home's file can state one with maestro:caller and maestro:reads.");
    }
    assertThat(rights.objection(SlParser.formula("(pleased ?p)"))).isPresent();
    assertThat(rights.objection(SlParser.formula("(>= (age Dave) 18)", "age"::equals))).isPresent();
    assertThat(rights.objection(SlParser.formula("(preferenceOf ?p Dave)"))).isEmpty();
    assertThat(rights.mayReadFact("(prefers dave-evenings Opera)")).isFalse();
    assertThat(rights.mayReadFact("(not (prefers dave-evenings Opera))")).isFalse();
    assertThat(rights.mayReadFact("(unknown (prefers dave-evenings Opera))")).isFalse();
    assertThat(rights.mayReadFact("(= (age Dave) 40)")).isFalse();
    assertThat(rights.mayReadFact("(looksLike Dave glasses)")).isTrue();
  }

  @Test
  void aPermissionThatNamesTheWordOpensItAndWhatFollowsFromItAlone() {
    String permission =
        "home:told a maestro:Permission ; maestro:caller \"nurse\" ; maestro:reads :prefers .";
    assertThat(rights(permission, "nurse").hidden()).containsExactly("age");
    assertThat(rights(permission, "thief").hidden()).hasSize(4);
    String narrow =
        "home:told a maestro:Permission ; maestro:caller \"*\" ; maestro:reads home:pleased .";
    assertThat(rights(narrow, "thief").hidden())
        .containsExactlyInAnyOrder("prefers", "age", "likesNews");
  }

  @Test
  void theOperatorOfAnOpenSiteReadsAllUntilTheHomeSaysWhoReads() {
    assertThat(PrivateWords.of(home(PRIVATE)).of(Set.of("desk"), true).areWhole()).isTrue();
    Home said =
        home(
            PRIVATE
                + "home:told a maestro:Permission ; maestro:caller \"nurse\" ; maestro:reads :prefers .");
    assertThat(PrivateWords.of(said).of(Set.of("desk"), true).hidden()).contains("prefers");
  }

  /** Who says who reads has not said who may not ask. */
  @Test
  void aPermissionToReadTakesNothingFromAnybodyAndLetsNobodyAsk() {
    String told =
        "home:told a maestro:Permission ; maestro:caller \"nurse\" ; maestro:reads :prefers .";
    Home open = home(PRIVATE + told);
    assertThat(AccessList.of(open).isOpen()).isTrue();
    Home closed =
        home(
            PRIVATE
                + told
                + "home:dims a maestro:Permission ; maestro:caller \"tablet\" ; maestro:asks :Lamp .");
    assertThat(AccessList.of(closed).knows(Set.of("tablet"))).isTrue();
    assertThat(AccessList.of(closed).knows(Set.of("nurse"))).isFalse();
  }

  @Test
  void whatCannotBeMeantSoIsAFault() {
    assertThat(fault(":prefers maestro:private \"yes\" ."))
        .contains("maestro:private", "is not true or false; write one of them");
    assertThat(fault(":prefers maestro:private true , false ."))
        .contains("is stated more than once; keep one");
    assertThat(fault("home:Dave maestro:private true ."))
        .contains("is neither a predicate nor a fluent");
    assertThat(
            fault(
                PRIVATE
                    + "home:t a maestro:Permission ; maestro:caller \"x\" ; maestro:reads :looksLike ."))
        .contains("t maestro:reads looksLike is no private word of this home");
  }

  @Test
  void aHomeSaysItOfAWordOfTheVocabularyAndHandsItOnWithItsOwnWords() {
    assertThat(new HomeLoader().vocabularyWith(home(PRIVATE).words()).predicate("prefers"))
        .hasValueSatisfying(word -> assertThat(word.isPrivate()).isTrue());
  }
}
