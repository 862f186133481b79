package org.maestro.language;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.language.grammar.GrammarFaultException;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeFacts;
import org.maestro.ontology.home.HomeFaultException;
import org.maestro.ontology.home.HomeLoader;

/**
 * Which language is spoken: that of the person, else of the home, else English; homes bring more.
 */
class SpokenLanguageTest {
  @TempDir Path folder;

  private static Home home(String ofTheHome, String ofBob) {
    return new HomeLoader().load(text(ofTheHome, ofBob), "tiny.ttl");
  }

  private static String text(String ofTheHome, String ofBob) {
    return """
        @prefix : <https://w3id.org/maestro/domain#> .
        @prefix home: <https://w3id.org/maestro/home/tiny#> .
        @prefix maestro: <https://w3id.org/maestro#> .
        @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
        <https://w3id.org/maestro/home/tiny> a maestro:Home ; %s rdfs:label "tiny"@en .
        home:room a maestro:Room , maestro:Zone ; rdfs:label "die Stube"@de ;
          maestro:outline "0 0, 4 0, 4 4, 0 4" ; maestro:height 2.5 ; maestro:referencePoint "2 2 0" .
        home:Bob a :Person ; %s rdfs:label "Bob"@en ; :colour "blue" ; :size "0.5 0.5 1.8" .
        """
        .formatted(said(ofTheHome), said(ofBob));
  }

  private static String said(String tag) {
    return tag.isEmpty() ? "" : "maestro:language \"%s\" ;".formatted(tag);
  }

  private static String spoken(String ofTheHome, String ofBob) {
    return Language.spoken(home(ofTheHome, ofBob), Optional.of("Bob"));
  }

  @Test
  void aPersonSpeaksHerLanguageElseThatOfTheHome() {
    assertThat(spoken("", "")).isEqualTo("en");
    assertThat(spoken("de", "")).isEqualTo("de");
    assertThat(spoken("", "de")).isEqualTo("de");
    assertThat(spoken("de", "en")).isEqualTo("en");
    assertThat(Language.spoken(home("de", "en"), Optional.empty())).isEqualTo("de");
  }

  @Test
  void whatIsNotShippedIsNotSpoken() {
    assertThat(spoken("xx", "")).isEqualTo("en");
    assertThatThrownBy(() -> Language.of(home("", ""), "xx"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "There is no grammar for the language xx; name one that is shipped, such as de, or a"
                + " file such as nl.grammar.");
    assertThatThrownBy(() -> Language.of(home("", ""), "../de"))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void aNameOfNoOtherLanguageIsOneInEach() {
    assertThat(Language.of(home("", ""), "de").lexicon().knows("bob")).isTrue();
    assertThat(Language.of(home("", ""), "en").lexicon().knows("stube")).isTrue();
  }

  private Home bringing(String tag, String grammar) throws IOException {
    Files.writeString(folder.resolve(tag + ".grammar"), grammar);
    return load(tag, "maestro:grammarFile \"%s.grammar\"".formatted(tag));
  }

  private Home load(String tag, String brought) throws IOException {
    Path file = folder.resolve("tiny.ttl");
    Files.writeString(
        file, text(tag, "") + "<https://w3id.org/maestro/home/tiny> %s .%n".formatted(brought));
    return new HomeLoader().load(file);
  }

  @Test
  void aHomeBringsALanguageAsAFileBesideItsOwn() throws IOException {
    Home home =
        bringing(
            "fr",
            """
            phrases like en
            language fr
            phrase greet = Bonjour.
            Utterance = a:Act
            Act = bonjour -> (greet)
            """);

    Language.check(home);
    assertThat(Language.spoken(home, Optional.of("Bob"))).isEqualTo("fr");
    assertThat(Language.isUnderstood(home, "fr")).isTrue();
    assertThat(reply(home, "Bonjour !")).contains("Bonjour.");
    assertThat(Language.of(home, "fr").grammar().phrase("answer-yes")).isEqualTo("Yes.");
  }

  private static Optional<String> reply(Home home, String said) {
    return Language.of(home, Language.spoken(home, Optional.of("Bob")))
        .understand(
            said,
            new Situation(
                home,
                new HomeFacts(home),
                Optional.of("Bob"),
                Optional.empty(),
                Optional.empty(),
                OptionalInt.empty(),
                Discourse.NONE))
        .reply();
  }

  @Test
  void aDialectIsAllThatItsLanguageIsAndMore() throws IOException {
    Home home = bringing("de-AT", "like de\nlanguage de-AT\nAct = servas -> (greet)\n");

    Language.check(home);
    assertThat(reply(home, "Servas")).contains("Hallo.");
    assertThat(reply(home, "Guten Abend")).contains("Hallo.");
    assertThat(Language.of(home, "de-AT").lexicon().knows("stube")).isTrue();
  }

  @Test
  void aGrammarThatIsNotWholeIsToldBeforeSomebodySpeaks() throws IOException {
    Home unlike = bringing("fr", "language fr\n");
    assertThatThrownBy(() -> Language.check(unlike))
        .isInstanceOf(GrammarFaultException.class)
        .hasMessage(
            "fr.grammar:1: has no phrase able; write it, or have those that are missing from a"
                + " shipped grammar by a line such as phrases like en.");
    Home misnamed = bringing("it", "language fr\nphrases like en\n");
    assertThatThrownBy(() -> Language.check(misnamed))
        .hasMessage(
            "it.grammar:1: is the grammar of fr; name the file fr.grammar, or write language it in"
                + " it.");
    Home unknown = bringing("nl", "language nl\nlike xx\n");
    assertThatThrownBy(() -> Language.check(unknown))
        .hasMessage("nl.grammar:2: there is no grammar xx; name one that is shipped, such as en.");
  }

  @Test
  void aFileThatIsNotThereIsAFaultOfTheHome() {
    assertThatThrownBy(() -> load("fr", "maestro:grammarFile \"fr.grammar\""))
        .isInstanceOf(HomeFaultException.class)
        .hasMessageContaining("maestro:grammarFile")
        .hasMessageContaining("put a file of that name, in UTF-8, beside the home's file");
    assertThatThrownBy(
            () ->
                new HomeLoader()
                    .load(
                        text("fr", "")
                            + "<https://w3id.org/maestro/home/tiny> maestro:wordsFile \"fr.ttl\" .",
                        "tiny.ttl"))
        .hasMessageContaining("cannot be found, as this home was not read from a file");
  }
}
