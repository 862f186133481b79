package org.maestro.language.meaning;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.maestro.language.grammar.Form;
import org.maestro.language.reference.NounPhrases;
import org.maestro.language.reference.Reference;
import org.maestro.language.reference.Relations;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.wording.Construction;
import org.maestro.sl.Content;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/** What constructions mean with what fills their roles. Bound to one reading. */
final class Frames {
  private static final String GOAL = "goal";
  private static final String TIME = "time";
  private static final String TEXT = "string";

  private final Situation situation;
  private final References references;
  private final States states;
  private final Function<Form, Optional<Formula>> conditions;

  /**
   * @param conditions what is so where a sentence about it holds
   */
  Frames(
      Situation situation,
      References references,
      States states,
      Function<Form, Optional<Formula>> conditions) {
    this.situation = situation;
    this.references = references;
    this.states = states;
    this.conditions = conditions;
  }

  /** The construction of a frame. */
  Construction construction(Form frame) {
    String name = frame.text(0);
    return situation.home().wording().constructions().stream()
        .filter(one -> one.name().equals(name))
        .findFirst()
        .orElseThrow(() -> new IllegalStateException("No construction is called " + name + "."));
  }

  /** The message of a frame. */
  Optional<Content> message(Form frame) {
    Construction construction = construction(frame);
    if (construction.means().isEmpty()) {
      references.die();
      return Optional.empty();
    }
    Map<String, Form> fillers = fillers(frame);
    if (!isFilled(construction, fillers)) {
      return Optional.empty();
    }
    Content means = construction.means().get();
    Optional<Content.Argument> goal = goal(means);
    if (goal.isEmpty()) {
      return plain(construction, fillers, means);
    }
    return formula(construction, fillers, goal.get()).map(formula -> Acts.goal(formula));
  }

  /** What is so when the frame is told. */
  Optional<Formula> holding(Form frame) {
    Construction construction = construction(frame);
    Map<String, Form> fillers = fillers(frame);
    Optional<Content.Argument> said =
        construction
            .holdsWhen()
            .<Content.Argument>map(Content.Argument.OfFormula::new)
            .or(() -> construction.means().flatMap(Frames::goal));
    if (said.isEmpty()) {
      references.die();
      return Optional.empty();
    }
    return isFilled(construction, fillers)
        ? formula(construction, fillers, said.get())
        : Optional.empty();
  }

  /** The frame of an act, where it is one and no other. */
  static Optional<Form> within(Form act) {
    if (act.is("frame")) {
      return Optional.of(act);
    }
    return switch (act.head()) {
      case "do", "instead", "yes", "both", "located", "excepting", "benefiting" ->
          act.parts().stream().map(Frames::within).flatMap(Optional::stream).findFirst();
      default -> Optional.empty();
    };
  }

  /** The time of the day that is said in a frame. */
  Optional<Form> clock(Form frame) {
    Map<String, Form> fillers = fillers(frame);
    return construction(frame).roles().stream()
        .filter(role -> role.type().equals(TIME))
        .map(role -> fillers.getOrDefault(role.name(), Form.HOLE))
        .filter(said -> !said.is("_"))
        .findFirst();
  }

  private static Map<String, Form> fillers(Form frame) {
    Map<String, Form> fillers = new LinkedHashMap<>();
    frame.parts().stream()
        .filter(part -> part.is("role"))
        .forEach(part -> fillers.put(part.text(0), part.part(1)));
    return fillers;
  }

  private boolean isFilled(Construction construction, Map<String, Form> fillers) {
    for (Construction.Role role : construction.roles()) {
      Form filler = fillers.getOrDefault(role.name(), Form.HOLE);
      if (filler.is("_") && !role.optional()) {
        if (!isOfFittingKinds(construction, fillers)) {
          references.die();
        }
        references.doubt(new Doubt.Missing(construction, role, fillers));
        return false;
      }
      if (role.type().equals(Construction.Role.RELATION) && !mayBeReached(filler)) {
        // Nothing is put from somewhere.
        references.die();
        return false;
      }
    }
    return true;
  }

  private boolean mayBeReached(Form where) {
    return where.is("_")
        || where.is("here")
        || where.is("there")
        || where.is("rel")
            && (where.part(0).is("_")
                || states.predicates(where.part(0)).stream().anyMatch(Relations::isBroughtAbout));
  }

  /** Whether what was said may be of the kinds that are wanted. */
  private boolean isOfFittingKinds(Construction construction, Map<String, Form> fillers) {
    return construction.roles().stream()
        .filter(this::isOfAClass)
        .filter(role -> !fillers.getOrDefault(role.name(), Form.HOLE).is("_"))
        .noneMatch(
            role ->
                references
                        .phrases()
                        .resolve(fillers.getOrDefault(role.name(), Form.HOLE), role.type())
                    instanceof Reference.Mistyped);
  }

  private static Optional<Content.Argument> goal(Content means) {
    return means.arguments().stream()
        .filter(Content.Argument.Named.class::isInstance)
        .map(Content.Argument.Named.class::cast)
        .filter(named -> named.name().equals(GOAL) && named.arguments().size() == 1)
        .map(named -> named.arguments().get(0))
        .findFirst();
  }

  private Optional<Formula> formula(
      Construction construction, Map<String, Form> fillers, Content.Argument said) {
    return bound(
        construction,
        fillers,
        0,
        Map.of(),
        terms -> {
          if (said instanceof Content.Argument.OfFormula ofFormula) {
            return spoken(ofFormula.formula(), terms);
          }
          if (said instanceof Content.Argument.OfTerm ofTerm
              && ofTerm.term() instanceof Term.Variable variable) {
            return relation(construction, variable.name(), fillers, terms);
          }
          references.die();
          return Optional.empty();
        });
  }

  private Optional<Formula> spoken(Formula formula, Map<String, Term> terms) {
    Map<String, Term> all = new HashMap<>(terms);
    situation.speaker().ifPresent(name -> all.putIfAbsent("speaker", new Term.Name(name)));
    situation.here().ifPresent(name -> all.putIfAbsent("here", new Term.Name(name)));
    situation.self().ifPresent(name -> all.putIfAbsent("self", new Term.Name(name)));
    return Optional.of(new Substitution(all).apply(formula));
  }

  /** Binds the roles one after the other, over all that each refers to. */
  private Optional<Formula> bound(
      Construction construction,
      Map<String, Form> fillers,
      int at,
      Map<String, Term> terms,
      Function<Map<String, Term>, Optional<Formula>> said) {
    if (at == construction.roles().size()) {
      return said.apply(terms);
    }
    Construction.Role role = construction.roles().get(at);
    Form filler = fillers.getOrDefault(role.name(), Form.HOLE);
    if (role.type().equals(Construction.Role.RELATION)) {
      return bound(construction, fillers, at + 1, terms, said);
    }
    if (filler.is("_")) {
      Optional<Term> usual = role.usually().flatMap(this::usual);
      Function<Map<String, Term>, Optional<Formula>> others =
          more -> bound(construction, fillers, at + 1, more, said);
      if (usual.isPresent() || !isOfAClass(role)) {
        Map<String, Term> more = new HashMap<>(terms);
        usual.ifPresent(term -> more.put(role.name(), term));
        return others.apply(more);
      }
      return references.over(
          unsaid(construction, role),
          term -> {
            Map<String, Term> more = new HashMap<>(terms);
            more.put(role.name(), term);
            return others.apply(more);
          });
    }
    Optional<Term> value = value(construction, role, filler);
    Function<Term, Optional<Formula>> next =
        term -> {
          Map<String, Term> more = new HashMap<>(terms);
          more.put(role.name(), term);
          return bound(construction, fillers, at + 1, more, said);
        };
    return value.isPresent()
        ? next.apply(value.get())
        : references.over(oneOf(construction, role, filler), role.type(), next);
  }

  /** Where only one can be at a time, songs are any of them. */
  private Form oneOf(Construction construction, Construction.Role role, Form filler) {
    return filler.is("np") && filler.text(0).equals("all") && isOneAtATime(construction, role)
        ? Form.of("np", Form.leaf("a"), filler.part(1))
        : filler;
  }

  private boolean isOneAtATime(Construction construction, Construction.Role role) {
    return construction
        .means()
        .flatMap(Frames::goal)
        .filter(Content.Argument.OfFormula.class::isInstance)
        .map(goal -> ((Content.Argument.OfFormula) goal).formula())
        .filter(Formula.Atom.class::isInstance)
        .map(Formula.Atom.class::cast)
        .filter(atom -> atom.arguments().size() > 1)
        .filter(
            atom ->
                atom.arguments()
                    .get(atom.arguments().size() - 1)
                    .equals(new Term.Variable(role.name())))
        .flatMap(atom -> situation.home().vocabulary().predicate(atom.predicate()))
        .filter(PredicateDeclaration::functional)
        .isPresent();
  }

  private Optional<Term> value(Construction construction, Construction.Role role, Form filler) {
    if (isOfAClass(role)) {
      return Optional.empty();
    }
    if (!role.type().equals(TIME)) {
      Optional<Term> value = Values.of(filler);
      if (value.isEmpty() && filler.is("quantity")) {
        // Minutes are no degrees.
        references.die();
      }
      return value;
    }
    OptionalInt minute =
        construction.inTheMorning()
            ? Values.minuteOfMorning(filler, situation.minuteOfDay())
            : Values.minuteOfDay(filler, situation.minuteOfDay());
    if (minute.isEmpty()) {
      references.die();
      return Optional.empty();
    }
    return Optional.of(new Term.Number(minute.getAsInt()));
  }

  /**
   * What was spoken of last, or is the only one here, or the only one there is, or of which it is
   * not so already.
   */
  private Reference unsaid(Construction construction, Construction.Role role) {
    NounPhrases phrases = references.phrases();
    Reference known = phrases.only(role.type(), term -> isKnownOf(construction, role.name(), term));
    return known instanceof Reference.Open
        ? phrases.only(role.type(), term -> isLacking(construction, role.name(), term))
        : known;
  }

  private boolean isLacking(Construction construction, String role, Term term) {
    return construction
        .means()
        .flatMap(Frames::goal)
        .filter(Content.Argument.OfFormula.class::isInstance)
        .map(goal -> ((Content.Argument.OfFormula) goal).formula())
        .map(goal -> new Substitution(Map.of(role, term)).apply(goal))
        .filter(goal -> FreeVariables.of(goal).isEmpty())
        .map(goal -> !references.phrases().relations().holds(goal, Map.of()))
        .orElse(false);
  }

  private Optional<Term> only(Construction construction, Construction.Role role) {
    return isOfAClass(role) && unsaid(construction, role) instanceof Reference.Single single
        ? Optional.of(single.term())
        : Optional.empty();
  }

  private boolean isOfAClass(Construction.Role role) {
    return situation.home().vocabulary().classes().containsKey(role.type());
  }

  /** Whether the numbers that the message names are known of this thing. */
  private boolean isKnownOf(Construction construction, String role, Term term) {
    String means = construction.means().map(SlPrinter::print).orElse("");
    Matcher named =
        Pattern.compile("\\(([^\\s()]+) \\?" + Pattern.quote(role) + "\\)").matcher(means);
    return named
        .results()
        .map(found -> found.group(1))
        .filter(situation.home().vocabulary()::isFluent)
        .allMatch(
            fluent ->
                situation.facts().number(new Expression.Fluent(fluent, List.of(term))).isPresent());
  }

  private Optional<Term> usual(Term term) {
    if (!(term instanceof Term.Variable variable)) {
      return Optional.of(term);
    }
    Optional<String> name =
        switch (variable.name()) {
          case "speaker" -> situation.speaker();
          case "here" -> situation.here();
          case "self" -> situation.self();
          default -> Optional.empty();
        };
    return name.map(Term.Name::new);
  }

  private Optional<Formula> relation(
      Construction construction, String role, Map<String, Form> fillers, Map<String, Term> terms) {
    Form where = fillers.getOrDefault(role, Form.HOLE);
    Optional<Term> thing =
        construction.roles().stream()
            .filter(one -> one.name().equals(role))
            .findFirst()
            .flatMap(Construction.Role::relates)
            .flatMap(
                related ->
                    related.startsWith("?")
                        ? usual(new Term.Variable(related.substring(1)))
                        : Optional.ofNullable(terms.get(related)));
    if (thing.isEmpty()) {
      references.die();
      return Optional.empty();
    }
    return where.is("here") || where.is("there")
        ? situation
            .here()
            .flatMap(
                here ->
                    goalAt(states.places(), thing.get(), new Reference.Single(new Term.Name(here))))
        : goalAt(where, thing.get());
  }

  private Optional<Formula> goalAt(Form where, Term thing) {
    if (!where.is("rel")) {
      references.die();
      return Optional.empty();
    }
    List<Reference> broken = new ArrayList<>();
    List<PredicateDeclaration> settable =
        states.predicates(where.part(0)).stream().filter(Relations::isBroughtAbout).toList();
    for (PredicateDeclaration predicate : settable) {
      Reference place = references.phrases().resolve(where.part(1), Relations.typeOf(predicate, 1));
      if (place instanceof Reference.Mistyped || !mayBeFirst(predicate, thing)) {
        continue;
      }
      if (place instanceof Reference.None) {
        broken.add(place);
        continue;
      }
      return goalAt(List.of(predicate), thing, place);
    }
    if (broken.isEmpty()) {
      references.die();
    } else {
      references.over(broken.get(0), term -> Optional.empty());
    }
    return Optional.empty();
  }

  private boolean mayBeFirst(PredicateDeclaration predicate, Term thing) {
    return !thing.isGround() || references.phrases().relations().fits(predicate, 0, thing);
  }

  private Optional<Formula> goalAt(
      List<PredicateDeclaration> predicates, Term thing, Reference place) {
    return predicates.stream()
        .filter(Relations::isBroughtAbout)
        .filter(predicate -> mayBeFirst(predicate, thing))
        .findFirst()
        .flatMap(
            predicate ->
                references.over(
                    place,
                    where ->
                        Optional.of(new Formula.Atom(predicate.name(), List.of(thing, where)))));
  }

  /** A message that is no goal: what fills the roles stands in it as it is. */
  private Optional<Content> plain(
      Construction construction, Map<String, Form> fillers, Content means) {
    Map<String, List<Term>> terms = new HashMap<>();
    Map<String, Formula> formulas = new HashMap<>();
    for (Construction.Role role : construction.roles()) {
      Form filler = fillers.getOrDefault(role.name(), Form.HOLE);
      if (role.type().equals(Construction.Role.CONDITION) && !filler.is("_")) {
        Optional<Formula> condition = conditions.apply(filler);
        if (condition.isEmpty()) {
          return Optional.empty();
        }
        formulas.put(role.name(), condition.get());
        continue;
      }
      if (filler.is("_")) {
        role.usually()
            .flatMap(this::usual)
            .or(() -> only(construction, role))
            .ifPresent(term -> terms.put(role.name(), List.of(term)));
        continue;
      }
      Optional<List<Term>> value =
          value(construction, role, filler)
              .map(List::of)
              .or(() -> references.terms(filler, role.type()));
      if (value.isEmpty()) {
        return Optional.empty();
      }
      if (!role.optional() && hasText(construction) && isSpeaker(value.get())) {
        // Nobody has himself told something.
        references.die();
      }
      terms.put(role.name(), value.get());
    }
    situation.speaker().ifPresent(name -> terms.put("speaker", List.of(new Term.Name(name))));
    situation.here().ifPresent(name -> terms.put("here", List.of(new Term.Name(name))));
    situation.self().ifPresent(name -> terms.put("self", List.of(new Term.Name(name))));
    return Optional.of(new Filling(terms, formulas).filled(means));
  }

  private static boolean hasText(Construction construction) {
    return construction.roles().stream().anyMatch(role -> role.type().equals(TEXT));
  }

  private boolean isSpeaker(List<Term> terms) {
    return situation.speaker().map(Term.Name::new).filter(terms::contains).isPresent();
  }

  /** What stands in the places of a message's variables. */
  private record Filling(Map<String, List<Term>> terms, Map<String, Formula> formulas) {

    Content filled(Content content) {
      return new Content(
          content.operator(), content.arguments().stream().flatMap(this::filled).toList());
    }

    private Stream<Content.Argument> filled(Content.Argument argument) {
      if (argument instanceof Content.Argument.OfTerm ofTerm) {
        return filled(ofTerm);
      } else if (argument instanceof Content.Argument.Named named) {
        return Stream.of(
            new Content.Argument.Named(
                named.name(), named.arguments().stream().flatMap(this::filled).toList()));
      } else if (argument instanceof Content.Argument.Nested nested) {
        return Stream.of(new Content.Argument.Nested(filled(nested.content())));
      } else if (argument instanceof Content.Argument.OfFormula ofFormula) {
        Map<String, Term> single = new HashMap<>();
        terms.forEach((name, values) -> single.put(name, values.get(0)));
        return Stream.of(
            new Content.Argument.OfFormula(new Substitution(single).apply(ofFormula.formula())));
      }
      return Stream.of(argument);
    }

    private Stream<Content.Argument> filled(Content.Argument.OfTerm argument) {
      if (argument.term() instanceof Term.Variable variable) {
        Optional<Formula> formula = Optional.ofNullable(formulas.get(variable.name()));
        return formula.isPresent()
            ? Stream.of(new Content.Argument.OfFormula(formula.get()))
            : terms.getOrDefault(variable.name(), List.of(variable)).stream()
                .map(Content.Argument.OfTerm::new);
      }
      return Stream.of(
          argument.term() instanceof Term.Text text
              ? new Content.Argument.OfTerm(new Term.Text(written(text.value())))
              : argument);
    }

    /** A text in which variables stand, such as that of facts. */
    private String written(String text) {
      String filled = text;
      for (Map.Entry<String, List<Term>> entry : terms.entrySet()) {
        filled =
            filled.replaceAll(
                "\\?" + Pattern.quote(entry.getKey()) + "\\b",
                Matcher.quoteReplacement(SlPrinter.print(entry.getValue().get(0))));
      }
      return filled;
    }
  }
}
