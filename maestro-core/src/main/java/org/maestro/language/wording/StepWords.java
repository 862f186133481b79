package org.maestro.language.wording;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Effect;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * Steps of plans as people speak of them: what sets a number is told by what is done with it, all
 * else by the feature's own sentence with names in it. Immutable.
 */
public final class StepWords {
  private static final Pattern PLACE = Pattern.compile("\\{([\\w-]+)}");

  private final Home home;
  private final Phrases phrases;
  private final DeedWords deeds;
  private final ReportWords reports;

  /**
   * In a language.
   *
   * @param listener the person who is spoken to, by her name in the home
   */
  public StepWords(Home home, Grammar grammar, Optional<String> listener) {
    this.home = home;
    this.phrases = new Phrases(grammar);
    this.deeds = new DeedWords(home, grammar, listener);
    this.reports = new ReportWords(home, grammar, listener);
  }

  /**
   * A sentence that tells it.
   *
   * @param member who does it
   * @param feature of the member, by its name
   * @param told the feature's sentence, with ids in its places
   */
  public String of(String member, String feature, String told) {
    return Optional.ofNullable(home.devices().get(member)).stream()
        .map(Device::features)
        .flatMap(List::stream)
        .filter(one -> one.name().equals(feature))
        .findFirst()
        .flatMap(one -> set(one, member, told))
        .flatMap(deeds::doing)
        .map(doing -> phrases.of("doing", Map.of("doing", doing)))
        .orElseGet(() -> Phrases.sentence(reports.of(told)));
  }

  /** The number of its own that it sets, and to what. */
  private static Optional<Formula> set(FeatureType feature, String member, String told) {
    Map<String, Term> values = values(feature.sentence(), told);
    values.put(Self.NAME, new Term.Name(member));
    List<Formula> set =
        effects(feature.effect())
            .filter(Effect.Change.class::isInstance)
            .map(Effect.Change.class::cast)
            .filter(change -> change.assignment() == Effect.Assignment.ASSIGN)
            .filter(change -> change.fluent().arguments().equals(List.of(Self.VARIABLE)))
            .<Formula>map(
                change ->
                    new Formula.Comparison(Formula.Relation.EQUAL, change.fluent(), change.value()))
            .toList();
    return set.size() == 1
        ? Optional.of(new Substitution(values).apply(set.get(0)))
        : Optional.empty();
  }

  private static Stream<Effect> effects(Effect effect) {
    return effect instanceof Effect.All all
        ? all.effects().stream().flatMap(StepWords::effects)
        : Stream.of(effect);
  }

  /** What stands in the places of the feature's sentence. */
  private static Map<String, Term> values(String sentence, String told) {
    List<String> names = new ArrayList<>();
    StringBuilder pattern = new StringBuilder();
    Matcher places = PLACE.matcher(sentence);
    int at = 0;
    while (places.find()) {
      names.add(places.group(1));
      pattern.append(Pattern.quote(sentence.substring(at, places.start()))).append("(\\S+)");
      at = places.end();
    }
    Matcher found = Pattern.compile(pattern + Pattern.quote(sentence.substring(at))).matcher(told);
    Map<String, Term> values = new HashMap<>();
    for (int i = 0; found.matches() && i < names.size(); i++) {
      values.put(names.get(i), SlParser.term(found.group(i + 1)));
    }
    return values;
  }
}
