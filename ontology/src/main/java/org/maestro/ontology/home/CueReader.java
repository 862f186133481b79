package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.apache.jena.graph.Node;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.VocabularyCheck;
import org.maestro.sl.Fact;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;

/** Reads what vocabulary and home state as cues; what makes no sense becomes a fault. */
final class CueReader {
  private static final Node CUE = Maestro.term("cue");
  private static final List<String> VARIABLES =
      List.of(Self.NAME, PersonCue.PERSON, PersonCue.ZONE);

  private final SourceGraph graph;
  private final VocabularyCheck check;
  private final Literals literals;

  CueReader(SourceGraph graph, VocabularyCheck check) {
    this.graph = graph;
    this.check = check;
    this.literals = new Literals(graph);
  }

  /** All, in the order in which they are stated. */
  List<PersonCue> read() {
    List<PersonCue> cues = new ArrayList<>();
    for (Node subject : graph.subjectsWith(CUE)) {
      for (Node cue : graph.objects(subject, CUE)) {
        read(subject, cue).ifPresent(cues::add);
      }
    }
    return cues;
  }

  private Optional<PersonCue> read(Node subject, Node node) {
    Optional<Fact> fact = literals.parsed(node, "fact", SlParser::fact);
    OptionalDouble hit = literals.number(node, "hitRate");
    OptionalDouble miss = literals.number(node, "falseRate");
    if (fact.isEmpty() || !(fact.get() instanceof Fact.Holds holds)) {
      fault(subject, "has no plain fact", "write one, such as maestro:fact \"(presence ?self)\"");
      return Optional.empty();
    }
    if (!isRate(hit) || !isRate(miss) || hit.getAsDouble() <= miss.getAsDouble()) {
      fault(
          subject,
          "has no maestro:hitRate above its maestro:falseRate, both between 0 and 1",
          "write both, such as 0.95 and 0.02");
      return Optional.empty();
    }
    PersonCue cue =
        new PersonCue(
            Literals.name(subject),
            holds.atom(),
            hit.getAsDouble(),
            miss.getAsDouble(),
            literals.duration(node, "countsAgainAfter"),
            literals.flag(node, "spoken"));
    if (!cue.isOfDevices() && !(cue.namesThePerson() && cue.namesTheZone())
        || !VARIABLES.containsAll(FreeVariables.of(cue.fact()))) {
      fault(
          subject,
          "has a fact that does not tell of whom or where it speaks",
          "write it over ?self, or over ?person and ?zone");
      return Optional.empty();
    }
    check.checkFormula(node, "fact", VARIABLES, cue.fact());
    return Optional.of(cue);
  }

  private static boolean isRate(OptionalDouble rate) {
    return rate.isPresent() && rate.getAsDouble() > 0 && rate.getAsDouble() < 1;
  }

  private void fault(Node subject, String problem, String cure) {
    graph.fault(subject, CUE, Optional.empty(), problem, cure);
  }
}
