package org.maestro.platform.journal;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.SearchReport;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/** The JSON of those journal entries that tell what goals have learnt on their way. */
final class MemoryCodec {
  private final Predicate<String> fluents;

  /**
   * @param fluents which predicates have numbers as values
   */
  MemoryCodec(Predicate<String> fluents) {
    this.fluents = fluents;
  }

  void write(ObjectNode line, JournalEntry.OfGoal entry) {
    if (entry instanceof JournalEntry.Failed failed) {
      JournalCodec.step(JournalCodec.event(line, "failed", failed.goalId()), failed.step());
      line.put("facts", failed.facts());
      line.put("count", failed.count());
      line.put("chances", failed.chances());
      line.put("refused", failed.refused());
      line.put("problem", failed.problem());
      ArrayNode taught = line.putArray("taught");
      for (FeatureRun.Learnt learnt : failed.taught()) {
        ObjectNode node = taught.addObject();
        node.put("fact", learnt.fact());
        node.put("value", SlPrinter.print(learnt.value()));
        learnt.need().ifPresent(need -> node.put("need", need));
      }
    } else if (entry instanceof JournalEntry.LookedInVain vain) {
      JournalCodec.step(JournalCodec.event(line, "looked-in-vain", vain.goalId()), vain.step());
      line.put("sought", SlPrinter.print(vain.atom()));
      line.put("place", vain.look().place());
      line.put("by", vain.look().by());
      line.put("looked_s", JournalCodec.seconds(vain.look().at()));
      vain.look().coveredShare().ifPresent(share -> line.put("covered", share));
    } else if (entry instanceof JournalEntry.Settings settings) {
      ArrayNode list = JournalCodec.event(line, "settings", settings.goalId()).putArray("settings");
      for (JournalEntry.Setting setting : settings.settings()) {
        ObjectNode node = list.addObject();
        node.put("number", SlPrinter.print(setting.fluent()));
        node.put("before", setting.before());
        node.put("value", setting.value());
        JournalCodec.step(node, setting.step());
      }
    } else if (entry instanceof JournalEntry.Noted noted) {
      JournalCodec.event(line, "noted", noted.goalId());
      line.put("path", noted.path());
      line.put("over", noted.over());
      noted.value().ifPresent(value -> line.put("value", SlPrinter.print(value)));
      noted.problem().ifPresent(problem -> line.put("problem", problem));
      noted.until().ifPresent(until -> line.put("until_s", JournalCodec.seconds(until)));
    } else if (entry instanceof JournalEntry.AttemptOver over) {
      JournalCodec.event(line, "attempt-over", over.goalId());
    } else if (entry instanceof JournalEntry.Asked asked) {
      JournalCodec.event(line, "asked", asked.goalId());
      line.put("petition", asked.petition());
      line.put("effect", SlPrinter.print(asked.effect()));
    }
  }

  /**
   * Reads what {@link #write} wrote.
   *
   * @throws IllegalArgumentException when nobody knows such an event
   */
  JournalEntry read(String event, JsonNode line, String goal, Timeline from, Timeline to) {
    return switch (event) {
      case "failed" ->
          new JournalEntry.Failed(
              goal,
              JournalCodec.readStep(line),
              line.path("facts").asText(),
              line.path("count").asInt(),
              line.path("chances").asInt(),
              line.path("refused").asBoolean(),
              line.path("problem").asText(),
              taught(line.path("taught")));
      case "noted" ->
          new JournalEntry.Noted(
              goal,
              line.path("path").asText(),
              line.path("over").asBoolean(),
              Optional.ofNullable(line.path("value").textValue()).map(SlParser::term),
              Optional.ofNullable(line.path("problem").textValue()),
              line.has("until_s")
                  ? Optional.of(JournalCodec.time(line, "until_s", from, to))
                  : Optional.empty());
      case "looked-in-vain" ->
          new JournalEntry.LookedInVain(
              goal,
              JournalCodec.readStep(line),
              (Formula.Atom) SlParser.formula(line.path("sought").asText(), fluents),
              new SearchReport.Look(
                  line.path("place").asText(),
                  line.path("by").asText(),
                  JournalCodec.time(line, "looked_s", from, to),
                  line.has("covered")
                      ? OptionalDouble.of(line.path("covered").asDouble())
                      : OptionalDouble.empty()));
      case "settings" -> new JournalEntry.Settings(goal, settings(line.path("settings")));
      case "attempt-over" -> new JournalEntry.AttemptOver(goal);
      case "asked" ->
          new JournalEntry.Asked(
              goal,
              line.path("petition").asText(),
              SlParser.formula(line.path("effect").asText(), fluents));
      default -> throw new IllegalArgumentException("nobody knows the event '" + event + "'");
    };
  }

  private static List<FeatureRun.Learnt> taught(JsonNode list) {
    List<FeatureRun.Learnt> taught = new ArrayList<>();
    for (JsonNode node : list) {
      taught.add(
          new FeatureRun.Learnt(
              node.path("fact").asText(),
              SlParser.term(node.path("value").asText()),
              node.has("need") ? Optional.of(node.path("need").asText()) : Optional.empty()));
    }
    return taught;
  }

  private List<JournalEntry.Setting> settings(JsonNode list) {
    List<JournalEntry.Setting> settings = new ArrayList<>();
    for (JsonNode node : list) {
      settings.add(
          new JournalEntry.Setting(
              (Expression.Fluent) SlParser.expression(node.path("number").asText()),
              node.path("before").asDouble(),
              node.path("value").asDouble(),
              JournalCodec.readStep(node)));
    }
    return settings;
  }
}
