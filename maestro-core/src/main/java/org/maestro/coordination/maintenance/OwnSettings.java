package org.maestro.coordination.maintenance;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.facts.ProgressedState;
import org.maestro.coordination.facts.Settings;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Change;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Term;

/**
 * The numbers that a held goal's own steps have set on their members, each with the value that it
 * had before, so that it can be seen what would be without them. A setting that somebody else
 * changes since is no longer the goal's own.
 */
final class OwnSettings {
  private static final double SAME = 1e-6;

  private final String goalId;
  private final Journal journal;
  private final Map<Expression.Fluent, Setting> settings = new LinkedHashMap<>();
  private final Map<Expression.Fluent, Optional<Setting>> underWay = new LinkedHashMap<>();
  private List<JournalEntry.Setting> written = List.of();

  /**
   * @param journal where they are written down, to be remembered beyond a restart
   */
  OwnSettings(String goalId, Journal journal) {
    this.goalId = goalId;
    this.journal = journal;
  }

  /** What was set before a restart, as far as the devices that did it are there. */
  void takeUp(List<JournalEntry.Setting> former, Home home) {
    for (JournalEntry.Setting setting : former) {
      feature(setting.step(), home)
          .ifPresent(
              feature ->
                  settings.put(
                      setting.fluent(),
                      new Setting(
                          setting.before(), setting.value(), step(setting.step(), feature))));
    }
    written = former;
  }

  private static Optional<FeatureType> feature(StepKey key, Home home) {
    return Optional.ofNullable(home.devices().get(key.member())).stream()
        .flatMap(device -> device.features().stream())
        .filter(feature -> feature.name().equals(key.feature()))
        .findFirst();
  }

  /** What it cost then does not matter: what it would cost is looked at. */
  private static Step step(StepKey key, FeatureType feature) {
    return new Step(1, key.member(), feature, key.bindings(), 0, 0, true, Set.of());
  }

  private void writeDown() {
    List<JournalEntry.Setting> now = new ArrayList<>();
    settings.forEach(
        (fluent, setting) ->
            now.add(
                new JournalEntry.Setting(
                    fluent, setting.before(), setting.value(), setting.step().key())));
    if (!now.equals(written)) {
      written = now;
      journal.write(new JournalEntry.Settings(goalId, now));
    }
  }

  private record Setting(double before, double value, Step step) {}

  boolean isEmpty() {
    return settings.isEmpty();
  }

  /** The steps that would make the settings as they are, from what was before them. */
  List<Step> steps() {
    List<Step> steps = new ArrayList<>();
    for (Setting setting : settings.values()) {
      if (!steps.contains(setting.step())) {
        steps.add(setting.step());
      }
    }
    return steps;
  }

  /**
   * The step is begun: what it sets is known as the goal's own from now on, whoever hears its end.
   */
  void begun(Step step, Facts before) {
    for (Expression.Fluent fluent : Settings.assigned(step)) {
      underWay.putIfAbsent(fluent, Optional.ofNullable(settings.get(fluent)));
    }
    noteAll(step, before);
  }

  /** The step is done; these were the facts when it began. */
  void done(Step step, Facts before) {
    restore(step);
    noteAll(step, before);
  }

  /** The step has failed: what was set before it stands. */
  void failed(Step step) {
    restore(step);
    writeDown();
  }

  private void restore(Step step) {
    for (Expression.Fluent fluent : Settings.assigned(step)) {
      Optional<Setting> former = underWay.remove(fluent);
      if (former != null) {
        settings.remove(fluent);
        former.ifPresent(setting -> settings.put(fluent, setting));
      }
    }
  }

  private void noteAll(Step step, Facts before) {
    Set<Expression.Fluent> assigned = Settings.assigned(step);
    for (Change change : ProgressedState.changes(before, step)) {
      if (change instanceof Change.OfNumber number
          && assigned.contains(number.fluent())
          && number.value().isPresent()) {
        note(number.fluent(), number.value().getAsDouble(), before, step);
      }
    }
    writeDown();
  }

  private void note(Expression.Fluent fluent, double value, Facts before, Step step) {
    Setting known = settings.get(fluent);
    OptionalDouble first =
        known == null ? before.number(fluent) : OptionalDouble.of(known.before());
    if (first.isEmpty() || Math.abs(first.getAsDouble() - value) <= SAME) {
      settings.remove(fluent);
    } else {
      settings.put(fluent, new Setting(first.getAsDouble(), value, step));
    }
  }

  /** Forgets what is no longer as it was set; what is being set is not so yet. */
  void compare(Facts now) {
    settings
        .entrySet()
        .removeIf(
            setting -> {
              OptionalDouble present = now.number(setting.getKey());
              return !underWay.containsKey(setting.getKey())
                  && (present.isEmpty()
                      || Math.abs(present.getAsDouble() - setting.getValue().value()) > SAME);
            });
    writeDown();
  }

  /** The facts as they would be, had each been set back to what it was before. */
  Facts without(Facts now, Vocabulary vocabulary) {
    Facts facts = now;
    for (Map.Entry<Expression.Fluent, Setting> setting : settings.entrySet()) {
      Step back =
          instance(
              setting.getValue().step(), setting.getValue().value(), setting.getValue().before());
      facts = ProgressedState.of(facts, vocabulary, back);
    }
    return facts;
  }

  /** The step with its parameters of one value given another. */
  private static Step instance(Step step, double value, double other) {
    Map<String, Term> bindings = new TreeMap<>(step.bindings());
    bindings.replaceAll(
        (name, term) ->
            term instanceof Term.Number number && Math.abs(number.value() - value) <= SAME
                ? new Term.Number(other)
                : term);
    return new Step(
        step.number(),
        step.member(),
        step.feature(),
        bindings,
        step.cost(),
        step.seconds(),
        step.exactPrice(),
        Set.of());
  }
}
