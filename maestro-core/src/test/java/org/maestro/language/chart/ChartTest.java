package org.maestro.language.chart;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.GrammarReader;

/** A chart grows with each word that fits, and is cut back. */
class ChartTest {
  private static final int MOST = 10;
  private static final String GRAMMAR =
      """
      language xx
      Utterance = a:Act
      Act = take o:Thing -> (take o)
      Act = take o:Thing to w:Thing -> (bring o w)
      Act = take o:Thing w:Where -> (takeat o w) !1
      Act = say t:Any -> (say t)
      Act = a:Act and b:Act -> (both a b) !1
      Thing = the n:Noun -> n
      Thing = n:Thing w:Where -> (at n w) !2
      Where = on n:Thing -> (on n)
      """;

  /** Words of a lexicon, of which one entry is of two words. */
  private static final class Words implements WordEntries {
    private final Map<List<String>, Entry> entries =
        Map.of(
            List.of("cup"), new Entry("Noun", 1, Form.leaf("Cup")),
            List.of("table"), new Entry("Noun", 1, Form.leaf("Table")),
            List.of("coffee", "table"), new Entry("Noun", 2, Form.leaf("CoffeeTable")));

    @Override
    public List<Entry> endingWith(List<String> words) {
      List<Entry> found = new ArrayList<>();
      found.add(new Entry(ANY, 1, Form.leaf(words.get(words.size() - 1))));
      for (int size = 1; size <= Math.min(2, words.size()); size++) {
        Entry entry = entries.get(words.subList(words.size() - size, words.size()));
        if (entry != null) {
          found.add(entry);
        }
      }
      return found;
    }

    @Override
    public boolean isBeginning(List<String> words, Predicate<String> categories) {
      return words.equals(List.of("coffee")) && categories.test("Noun");
    }

    @Override
    public int longest() {
      return 2;
    }

    @Override
    public Set<String> next(
        List<String> words, Predicate<String> categories, String begin, int most) {
      return entries.keySet().stream()
          .filter(entry -> categories.test("Noun") && entry.size() > words.size())
          .filter(entry -> entry.subList(0, words.size()).equals(words))
          .map(entry -> entry.get(words.size()))
          .filter(word -> word.startsWith(begin))
          .collect(Collectors.toSet());
    }
  }

  private static Chart chart(Predicate<Form> possible) {
    RuleIndex rules = new RuleIndex(GrammarReader.read(GRAMMAR, "xx.grammar"));
    return new Chart(rules, new Words(), possible);
  }

  private static Chart after(String text) {
    Chart chart = chart(form -> true);
    for (String word : text.split(" ")) {
      assertThat(chart.extend(word)).as(word).isTrue();
    }
    return chart;
  }

  private static List<String> forms(List<Reading> readings) {
    return readings.stream().map(reading -> reading.form().toString()).toList();
  }

  @Test
  void wordsThatFitMakeAReading() {
    assertThat(forms(after("take the cup").complete())).containsExactly("(take Cup)");
    assertThat(after("take the").complete()).isEmpty();
    assertThat(chart(form -> true).complete()).isEmpty();
  }

  @Test
  void aWordThatDoesNotFitLeavesTheChartAsItWas() {
    Chart chart = after("take the");

    assertThat(chart.extend("take")).isFalse();
    assertThat(chart.extend("lamp")).isFalse();

    assertThat(chart.words()).containsExactly("take", "the");
    assertThat(chart.extend("cup")).isTrue();
    assertThat(forms(chart.complete())).containsExactly("(take Cup)");
  }

  @Test
  void theUsualReadingIsTheFirst() {
    assertThat(after("take the cup on the table").complete())
        .containsExactly(
            new Reading(Form.of("takeat", Form.leaf("Cup"), Form.of("on", Form.leaf("Table"))), 1),
            new Reading(
                Form.of("take", Form.of("at", Form.leaf("Cup"), Form.of("on", Form.leaf("Table")))),
                2));
  }

  @Test
  void severalWordsMayBeOneEntry() {
    Chart chart = after("take the coffee");

    assertThat(chart.complete()).isEmpty();
    assertThat(chart.extend("cup")).isFalse();
    assertThat(chart.extend("table")).isTrue();
    assertThat(forms(chart.complete())).containsExactly("(take CoffeeTable)");
  }

  @Test
  void whatIsCutIsForgotten() {
    Chart chart = after("take the cup on the table");

    chart.cut(2);

    assertThat(chart.size()).isEqualTo(2);
    assertThat(chart.extend("coffee")).isTrue();
    assertThat(chart.extend("table")).isTrue();
    assertThat(forms(chart.complete())).containsExactly("(take CoffeeTable)");
    chart.cut(0);
    assertThat(chart.words()).isEmpty();
    assertThat(chart.extend("say")).isTrue();
  }

  @Test
  void whatWasSaidSoFarHasAHoleForTheRest() {
    assertThat(forms(after("take").partial(form -> true))).contains("(take _)", "(bring _ _)");
    assertThat(forms(after("take the cup to").partial(form -> true))).contains("(bring Cup _)");
    assertThat(forms(after("take the cup to").begun("bring"))).contains("(bring Cup _)");
    assertThat(after("take the cup to").begun("say")).isEmpty();
  }

  @Test
  void whatCannotBeMeantIsNoReading() {
    Chart chart = chart(form -> !form.is("takeat"));
    List.of("take", "the", "cup", "on", "the", "table").forEach(chart::extend);

    assertThat(forms(chart.complete())).containsExactly("(take (at Cup (on Table)))");
  }

  @Test
  void whicheverWordIsTakenOnlyFreely() {
    assertThat(forms(after("say anything").complete())).containsExactly("(say anything)");
    assertThat(after("say").extend("anything", false)).isFalse();
  }

  @Test
  void whatCouldComeNextIsKnown() {
    assertThat(chart(form -> true).next("", MOST)).containsExactly("say", "take");
    Chart chart = after("take the");
    assertThat(chart.next("", MOST)).containsExactly("coffee", "cup", "table");
    assertThat(chart.next("c", 1)).containsExactly("coffee");
    assertThat(after("take the coffee").next("", MOST)).containsExactly("table");
    assertThat(chart.predicts("Noun")).isTrue();
    assertThat(chart.predicts("Where")).isFalse();
    chart.extend("cup");
    assertThat(chart.next("", MOST)).containsExactly("and", "on", "to");
    assertThat(chart.next("t", MOST)).containsExactly("to");
  }

  @Test
  void howeverAmbiguousReadingsStayFew() {
    String text = "take the cup" + " on the table".repeat(30);

    assertThat(after(text).complete()).isNotEmpty().hasSizeLessThanOrEqualTo(16);
  }
}
