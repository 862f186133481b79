package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.apache.jena.graph.Node;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.vocabulary.VocabularyCheck;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** Reads the goals that agents have of their own accord, and the groups that some stand for. */
final class Aims {
  private static final Node PURSUES = Maestro.term("pursues");
  private static final Node MEMBER = Maestro.term("member");

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final VocabularyCheck check;
  private final Literals literals;
  private final Predicate<String> scripts;

  /**
   * @param scripts whether a name is that of a script, whose use is checked when all are read
   */
  Aims(SourceGraph graph, Vocabulary vocabulary, VocabularyCheck check, Predicate<String> scripts) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.check = check;
    this.literals = new Literals(graph);
    this.scripts = scripts;
  }

  /** The goals that a node states; free variables are existential, {@code ?self} is the agent. */
  List<Formula> pursued(Node node) {
    List<Formula> goals = new ArrayList<>();
    for (Node value : graph.objects(node, PURSUES)) {
      Optional<Formula> goal =
          literals.parsed(
              node, PURSUES, value, text -> SlParser.formula(text, vocabulary::isFluent));
      goal.ifPresent(
          formula -> {
            if (!isScript(formula)) {
              Set<String> variables = new LinkedHashSet<>(FreeVariables.of(formula));
              variables.add(Self.NAME);
              check.checkFormula(node, "pursues", variables, formula);
            }
            goals.add(formula);
          });
    }
    return goals;
  }

  /** What a node says that each of its goals is worth; {@code ?self} is the agent. */
  StatedWorth worth(Node node) {
    StatedWorth worth = new WorthReader(graph).read(node);
    worth
        .benefit()
        .ifPresent(benefit -> check.checkExpression(node, "benefit", List.of(Self.NAME), benefit));
    return worth;
  }

  private boolean isScript(Formula goal) {
    return goal instanceof Formula.Atom atom && scripts.test(atom.predicate());
  }

  /** The group that a node describes. */
  Group group(Node node, Individual individual) {
    Set<String> members = new LinkedHashSet<>();
    for (Node member : graph.objects(node, MEMBER)) {
      if (graph.predicates(member).isEmpty()) {
        graph.fault(
            node,
            MEMBER,
            Optional.of(member),
            "is not described in this home",
            "describe it, or name another device");
      }
      members.add(Literals.name(member));
    }
    Optional<Formula> condition =
        literals.parsed(node, "memberWhen", text -> SlParser.formula(text, vocabulary::isFluent));
    condition.ifPresent(
        formula -> check.checkFormula(node, "memberWhen", List.of("member"), formula));
    List<Formula> goals = pursued(node);
    Optional<RoomHearing> hearing =
        individual.classes().contains("RoomAgent")
            ? Optional.of(
                new RoomHearing(
                    names(node, "hears"),
                    names(node, "understands"),
                    literals.text(node, "persona")))
            : Optional.empty();
    if (graph.objects(node, PURSUES).isEmpty() && hearing.isEmpty()) {
      graph.fault(
          node, "has no maestro:pursues", "state its goal, such as \"(keep ...)\" in MAESTRO-SL");
    }
    return new Group(
        individual,
        literals.text(node, "container"),
        members,
        condition,
        goals,
        new WorthReader(graph).read(node),
        graph
            .object(node, Maestro.term("plans"))
            .filter(value -> Literals.term(value).equals(new Term.Truth(false)))
            .isEmpty(),
        hearing);
  }

  private Set<String> names(Node node, String property) {
    return graph.objects(node, Maestro.term(property)).stream()
        .map(Literals::name)
        .collect(Collectors.toSet());
  }
}
