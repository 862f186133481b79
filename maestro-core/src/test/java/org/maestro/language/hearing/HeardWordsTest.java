package org.maestro.language.hearing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.language.chart.Chart;
import org.maestro.language.chart.RuleIndex;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.grammar.GrammarReader;
import org.maestro.language.lexicon.Lexicon;
import org.maestro.language.lexicon.LexiconOfHome;
import org.maestro.language.lexicon.Tokens;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** Words are heard with fillers, repairs and slips, and what became of each is told. */
class HeardWordsTest {
  private static final Home HOME =
      new HomeLoader()
          .load(
              """
              @prefix : <https://w3id.org/maestro/domain#> .
              @prefix home: <https://w3id.org/maestro/home/tiny#> .
              @prefix maestro: <https://w3id.org/maestro#> .
              @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
              <https://w3id.org/maestro/home/tiny> a maestro:Home ; rdfs:label "tiny"@en .
              home:room a maestro:Room , maestro:Zone ; rdfs:label "the parlour"@en ;
                maestro:outline "0 0, 4 0, 4 4, 0 4" ; maestro:height 2.5 ; maestro:referencePoint "2 2 0" .
              home:Ann a :Person ; rdfs:label "Ann"@en ; :colour "blue" ; :size "0.5 0.5 1.8" .
              home:cup a :Item ; rdfs:label "the teacup"@en ; :colour "red" ; :size "0.1 0.1 0.1" ; :mass 0.2 .
              home:saucer a :Item ; rdfs:label "the saucer"@en ; :colour "red" ; :size "0.1 0.1 0.1" ; :mass 0.2 .
              """,
              "tiny.ttl");
  private static final Grammar GRAMMAR =
      GrammarReader.read(
          """
          language en
          list article = the
          list filler = uh, um, you know
          list filler = comma
          list repair = no, no wait, i mean, -
          number three = 3
          Utterance = a:Act
          Act = bring n:Np -> (bring n)
          Act = bring n:Np to p:Np -> (bring n p)
          Act = hand n:Np over -> (hand n)
          Np = a:Np , b:Np -> (and a b)
          Act = tell n:Np that t:Text -> (tell n t)
          Np = n:Name
          Text = a:Any
          Text = t:Text a:Any -> (text t a)
          """,
          "tiny.grammar");
  private static final Lexicon LEXICON = new LexiconOfHome(HOME, GRAMMAR).read();
  private static final RuleIndex RULES = new RuleIndex(GRAMMAR);

  private static HeardWords heard(String text) {
    HeardWords heard =
        new HeardWords(
            GRAMMAR,
            HeardWords.wordsOf(GRAMMAR),
            Set.of(),
            LEXICON,
            () -> new Chart(RULES, LEXICON, form -> true));
    new Tokens(GRAMMAR.spellings()).of(text).forEach(heard::take);
    heard.end();
    return heard;
  }

  private static List<String> forms(HeardWords heard) {
    return heard.readings().stream().map(reading -> reading.form().toString()).toList();
  }

  private static List<String> fates(HeardWords heard, Heard.Fate fate) {
    return heard.heard().stream().filter(word -> word.fate() == fate).map(Heard::word).toList();
  }

  @Test
  void wordsThatFitAreTaken() {
    HeardWords heard = heard("bring the teacup to Ann");

    assertThat(forms(heard)).containsExactly("(bring (name cup) (name Ann))");
    assertThat(heard.heard()).allMatch(word -> word.fate() == Heard.Fate.TAKEN);
    assertThat(heard.repairs()).isZero();
  }

  @Test
  void fillersAreLetGo() {
    HeardWords heard = heard("uh, bring, um, the, you know, teacup, uh");

    assertThat(forms(heard)).containsExactly("(bring (name cup))");
    assertThat(fates(heard, Heard.Fate.FILLER)).contains("uh", "um", "you", "know", ",");
  }

  @Test
  void whatIsSaidAgainIsOneOfIt() {
    assertThat(forms(heard("bring the the teacup"))).containsExactly("(bring (name cup))");
    assertThat(forms(heard("bring the, uh, the teacup"))).containsExactly("(bring (name cup))");
    assertThat(forms(heard("bring the, uh, bring the teacup")))
        .containsExactly("(bring (name cup))");
  }

  @Test
  void aRepairTakesBackFromWhereItGoesOn() {
    HeardWords heard = heard("bring the teacup, no, the saucer to Ann");

    assertThat(forms(heard)).containsExactly("(bring (name saucer) (name Ann))");
    assertThat(heard.repairs()).isEqualTo(1);
    assertThat(heard.withdrawn()).containsExactly("the", "teacup");
    assertThat(fates(heard, Heard.Fate.REPAIR)).containsExactly("no");
    assertThat(heard.chart().words()).containsExactly("bring", "the", "saucer", "to", "ann");
  }

  @Test
  void whatIsCorrectedIsNoListWithWhatItWas() {
    assertThat(forms(heard("bring the teacup, the saucer")))
        .containsExactly("(bring (and (name cup) (name saucer)))");
    assertThat(forms(heard("bring the teacup, no, the saucer")))
        .containsExactly("(bring (name saucer))");
  }

  @Test
  void whatWasSaidAfterWhatIsCorrectedCountsStill() {
    assertThat(forms(heard("hand the teacup over, no, the saucer")))
        .containsExactly("(hand (name saucer))");
    assertThat(forms(heard("hand the teacup, no, the saucer over")))
        .containsExactly("(hand (name saucer))");
    assertThat(forms(heard("hand the teacup, no, the saucer"))).isEmpty();
  }

  @Test
  void whatBeginsAgainTakesBackWhatWasSaidSinceItsFirstWord() {
    HeardWords heard = heard("bring the teacup to Ann, no, to the saucer");

    assertThat(forms(heard)).containsExactly("(bring (name cup) (name saucer))");
    assertThat(heard.withdrawn()).containsExactly("to", "ann");
  }

  @Test
  void aBreathIsNoListWhereNoneComes() {
    assertThat(forms(heard("bring the teacup, to Ann")))
        .containsExactly("(bring (name cup) (name Ann))");
    assertThat(forms(heard("bring the teacup, the"))).isEmpty();
  }

  @Test
  void aRepairMayBeOfSeveralWordsAndOfABrokenWord() {
    assertThat(forms(heard("bring the teacup, no wait, the saucer")))
        .containsExactly("(bring (name saucer))");
    assertThat(forms(heard("bring the teacup, I mean the saucer")))
        .containsExactly("(bring (name saucer))");
    assertThat(forms(heard("bring the teacup - the saucer")))
        .containsExactly("(bring (name saucer))");
  }

  @Test
  void aRepairAfterARepairCounts() {
    HeardWords heard = heard("bring the teacup, no, the saucer, no, the teacup");

    assertThat(forms(heard)).containsExactly("(bring (name cup))");
    assertThat(heard.repairs()).isEqualTo(2);
  }

  @Test
  void aRepairMakesGoodForAWordThatWasNotKnown() {
    HeardWords heard = heard("bring the zzyzx, no, the saucer");

    assertThat(heard.isBlocked()).isFalse();
    assertThat(forms(heard)).containsExactly("(bring (name saucer))");
  }

  @Test
  void aMisheardWordIsTakenForTheOnlyOneThatIsNearAndFits() {
    HeardWords heard = heard("bring the saucor");

    assertThat(forms(heard)).containsExactly("(bring (name saucer))");
    assertThat(heard.heard().get(2).fate()).isEqualTo(Heard.Fate.MISHEARD);
    assertThat(heard.heard().get(2).as()).contains("saucer");
  }

  @Test
  void aShortWordIsNotTakenForAnother() {
    assertThat(heard("bring Amn").isBlocked()).isTrue();
  }

  @Test
  void anUnknownWordBlocksWhatComesAfterIt() {
    HeardWords heard = heard("bring the zzyzx to Ann");

    assertThat(heard.isBlocked()).isTrue();
    assertThat(heard.readings()).isEmpty();
    assertThat(fates(heard, Heard.Fate.UNKNOWN)).containsExactly("zzyzx");
    assertThat(fates(heard, Heard.Fate.UNPLACED)).containsExactly("to", "ann");
  }

  @Test
  void aKnownWordInTheWrongPlaceIsNotUnknown() {
    HeardWords heard = heard("bring to the saucer");

    assertThat(heard.readings()).isEmpty();
    assertThat(fates(heard, Heard.Fate.UNKNOWN)).isEmpty();
    assertThat(fates(heard, Heard.Fate.UNPLACED)).startsWith("to");
  }

  @Test
  void whatIsToBeToldMayBeAnyWords() {
    HeardWords heard = heard("tell Ann that zzyzx zzyzx");

    assertThat(forms(heard)).containsExactly("(tell (name Ann) (text zzyzx zzyzx))");
  }

  @Test
  void fillersAtTheEndOfASentenceThatIsNotWholeDoNotMakeItWhole() {
    assertThat(heard("bring the, uh").readings()).isEmpty();
    assertThat(heard("bring the, no").readings()).isEmpty();
    assertThat(heard("uh").readings()).isEmpty();
    assertThat(heard("").readings()).isEmpty();
  }

  @Test
  void ofMoreWordsThanAnybodySaysNothingIsUnderstood() {
    assertThat(heard("tell Ann that " + "zzyzx ".repeat(100)).readings()).hasSize(1);

    HeardWords heard = heard("tell Ann that " + "zzyzx ".repeat(10_000) + "no, bring the saucer");

    assertThat(heard.isBlocked()).isTrue();
    assertThat(heard.readings()).isEmpty();
    assertThat(heard.heard()).hasSize(10_008);
  }

  @Test
  void wordsOfAGrammarAreThoseOfItsRulesAndNumbers() {
    assertThat(HeardWords.wordsOf(GRAMMAR))
        .containsExactlyInAnyOrder("bring", "hand", "over", ",", "to", "tell", "that", "three");
  }
}
