package org.maestro.language.wording;

import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.meaning.Doubt;
import org.maestro.language.meaning.Meaning;
import org.maestro.language.reference.NounPhrases;
import org.maestro.language.reference.Reference;
import org.maestro.language.reference.Relations;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.wording.Construction;
import org.maestro.ontology.wording.Said;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** What is asked back, or said instead, when something stays in doubt. */
public final class QuestionsBack {
  /** Of more things nobody wants to hear the names. */
  private static final int CHOICES = 4;

  private static final String ROOM = "Zone";
  private static final String PERSON = "Person";

  private final Situation situation;
  private final Grammar grammar;
  private final Naming naming;
  private final Phrases phrases;
  private final Relations relations;

  public QuestionsBack(Situation situation, Grammar grammar) {
    this.situation = situation;
    this.grammar = grammar;
    this.naming = new Naming(situation.home(), grammar);
    this.phrases = new Phrases(grammar);
    this.relations = new Relations(situation);
  }

  /** The sentence for a doubt. */
  public String of(Doubt doubt) {
    return Phrases.capitalized(sentence(doubt));
  }

  /**
   * The sentence for a doubt. Of what is not where it was said to be it is told where it is.
   *
   * @param alike those of readings that are as good
   */
  public String of(Doubt doubt, List<Doubt> alike) {
    return doubt instanceof Doubt.NoSuch
        ? alike.stream()
            .filter(Doubt.NoSuch.class::isInstance)
            .flatMap(none -> elsewhere(((Doubt.NoSuch) none).said()).stream())
            .findFirst()
            .orElseGet(() -> of(doubt))
        : of(doubt);
  }

  /** Where the only thing is of which it was said that it is somewhere else. */
  private Optional<String> elsewhere(Form said) {
    boolean isOfOne = said.is("np") && (said.text(0).equals("the") || said.text(0).equals("this"));
    if (!isOfOne || !said.part(1).is("at")) {
      return Optional.empty();
    }
    Form anywhere = Form.of("np", said.part(0), said.part(1).part(0));
    if (anywhere.part(1).is("at")) {
      return elsewhere(anywhere);
    }
    return new NounPhrases(situation).resolve(anywhere, "") instanceof Reference.Single single
            && single.term() instanceof Term.Name thing
        ? where(thing)
            .flatMap(facts()::sentence)
            .or(() -> Optional.of(phrases.of("not-there", Map.of("what", naming.of(thing)))))
        : Optional.empty();
  }

  private FactWords facts() {
    return new FactWords(situation.home(), grammar, situation.speaker());
  }

  private Optional<Formula> where(Term.Name thing) {
    return situation.home().wording().prepositions().keySet().stream()
        .map(situation.home().vocabulary()::predicate)
        .flatMap(Optional::stream)
        .filter(predicate -> predicate.parameters().size() == 2 && !predicate.symmetric())
        .sorted(Comparator.comparing(predicate -> !Relations.isBroughtAbout(predicate)))
        .flatMap(
            predicate ->
                places(predicate, thing)
                    .map(place -> new Formula.Atom(predicate.name(), List.of(thing, place)))
                    .limit(1))
        // On which table somebody finds it sooner than in which room.
        .min(Comparator.comparing(place -> relations.isA(place.arguments().get(1), ROOM)))
        .map(place -> place);
  }

  private String sentence(Doubt doubt) {
    if (doubt instanceof Doubt.Which which) {
      return which(which);
    } else if (doubt instanceof Doubt.Missing missing) {
      return missing(missing);
    } else if (doubt instanceof Doubt.NoSuch none) {
      return none(none.said());
    } else if (doubt instanceof Doubt.NotKnown unknown) {
      return phrases.of(
          "not-known",
          Map.of(
              "what", naming.word(unknown.fluent().name()),
              "whose",
                  unknown.fluent().arguments().stream()
                      .map(naming::of)
                      .collect(Collectors.joining(" "))));
    } else if (doubt instanceof Doubt.OutOfRange range) {
      return outOfRange(range);
    } else if (doubt instanceof Doubt.Unchanged unchanged) {
      return facts().sentence(unchanged.so()).orElseGet(() -> grammar.phrase("not-possible"));
    } else if (doubt instanceof Doubt.LeftOut leftOut) {
      return phrases.of(
          "without", Map.of("word", String.join(" ", leftOut.words()), "said", leftOut.rest()));
    } else if (doubt instanceof Doubt.Confirm) {
      return grammar.phrase("confirm");
    }
    return grammar.phrase("not-possible");
  }

  private String outOfRange(Doubt.OutOfRange range) {
    AmountWords amounts = new AmountWords(situation.home(), grammar);
    String least = amounts.exactly(range.fluent(), range.least());
    String what = naming.word(range.fluent());
    return range.most() == Double.MAX_VALUE
        ? phrases.of("at-least", Map.of("what", what, "least", least))
        : phrases.of(
            "out-of-range",
            Map.of(
                "what",
                what,
                "least",
                least,
                "most",
                amounts.exactly(range.fluent(), range.most())));
  }

  /**
   * What is asked when readings are as good: which kind of thing is meant, where they differ so.
   */
  public String between(List<Meaning> meanings) {
    Set<Term.Name> common = new LinkedHashSet<>(meanings.get(0).mentioned());
    meanings.forEach(meaning -> common.retainAll(meaning.mentioned()));
    List<Term.Name> different =
        meanings.stream()
            .flatMap(
                meaning ->
                    meaning.mentioned().stream().filter(thing -> !common.contains(thing)).limit(1))
            .distinct()
            .toList();
    List<String> names = different.stream().map(naming::of).distinct().toList();
    return names.size() == 2 ? betweenNames(names) : Phrases.capitalized(ofKinds(kinds(different)));
  }

  private String betweenNames(List<String> two) {
    return Phrases.capitalized(
        phrases.of("which-name", Map.of("first", two.get(0), "last", two.get(1))));
  }

  private List<String> kinds(List<Term.Name> candidates) {
    return candidates.stream().map(naming::kind).flatMap(Optional::stream).distinct().toList();
  }

  private String ofKinds(List<String> kinds) {
    return kinds.size() == 2
        ? phrases.of("which-kind", Map.of("first", kinds.get(0), "last", kinds.get(1)))
        : grammar.phrase("ambiguous");
  }

  private String missing(Doubt.Missing missing) {
    return missing.role().questions().stream()
        .filter(question -> question.isIn(grammar.language()))
        .map(Said::text)
        .map(text -> phrases.filled(text, roles(missing)))
        .findFirst()
        .orElseGet(() -> phrases.of("missing", Map.of("role", missing.role().name())));
  }

  private Map<String, String> roles(Doubt.Missing missing) {
    return missing.construction().roles().stream()
        .collect(
            Collectors.toMap(
                Construction.Role::name,
                role ->
                    person(role, missing.said())
                        .orElseGet(() -> grammar.phrase(phrase(role.type()))),
                (a, b) -> a));
  }

  /** The one that was said, or who speaks, if it is she or nobody was. */
  private Optional<String> person(Construction.Role role, Map<String, Form> said) {
    Optional<Term> speaker = situation.speaker().map(Term.Name::new);
    Optional<Form> form = Optional.ofNullable(said.get(role.name())).filter(one -> !one.is("_"));
    if (!role.type().equals(PERSON)) {
      return Optional.empty();
    }
    Optional<Term> meant =
        form.isPresent()
            ? form.map(one -> new NounPhrases(situation).resolve(one, PERSON))
                .filter(Reference.Single.class::isInstance)
                .map(one -> ((Reference.Single) one).term())
            : speaker.filter(any -> role.optional());
    return meant.map(
        one ->
            speaker.filter(one::equals).isPresent()
                ? grammar.phrase("you-object")
                : naming.of(one));
  }

  private static String phrase(String type) {
    return switch (type) {
      case Construction.Role.RELATION -> "role-where";
      case PERSON -> "role-person";
      default -> "role";
    };
  }

  private String which(Doubt.Which doubt) {
    List<Term.Name> candidates = doubt.candidates();
    String kind =
        noun(doubt.said())
            .or(() -> candidates.stream().findFirst().flatMap(naming::kind))
            .orElse("");
    List<String> names = candidates.stream().map(naming::of).distinct().toList();
    if (doubt.said().is("or") && names.size() == 2) {
      return betweenNames(names);
    }
    if (names.size() < candidates.size() && byPlace(candidates).isEmpty()) {
      List<String> kinds = kinds(candidates);
      return kinds.size() == 2 ? ofKinds(kinds) : phrases.of("which-of-many", Map.of("kind", kind));
    }
    List<String> choices =
        names.size() == candidates.size() ? names : byPlace(candidates).orElse(names);
    if (choices.size() > CHOICES) {
      return phrases.of("which-of-many", Map.of("kind", kind));
    }
    String last = choices.get(choices.size() - 1);
    String first = String.join(", ", choices.subList(0, choices.size() - 1));
    return phrases.of("which", Map.of("kind", kind, "first", first, "last", last));
  }

  /** The class that was said. */
  private Optional<String> noun(Form said) {
    return said.is("noun")
        ? Optional.of(naming.word(said.text(0)))
        : said.parts().stream().map(this::noun).flatMap(Optional::stream).findFirst();
  }

  /** Things by where they are, the one on the table, where that tells them apart. */
  private Optional<List<String>> byPlace(List<Term.Name> things) {
    if (things.size() > CHOICES) {
      return Optional.empty();
    }
    String kind = things.stream().findFirst().flatMap(naming::kind).orElse("");
    String article = phrases.article(kind);
    String instead = article.isEmpty() ? kind : article;
    for (Map.Entry<String, List<Said>> entry :
        situation.home().wording().prepositions().entrySet()) {
      Optional<String> word =
          entry.getValue().stream()
              .filter(said -> said.isIn(grammar.language()))
              .map(Said::text)
              .findFirst();
      Optional<PredicateDeclaration> predicate =
          situation.home().vocabulary().predicate(entry.getKey());
      if (word.isEmpty()
          || predicate.filter(one -> one.parameters().size() == 2 && !one.symmetric()).isEmpty()) {
        continue;
      }
      List<String> places =
          things.stream()
              .flatMap(thing -> place(predicate.get(), thing).stream())
              .distinct()
              .toList();
      if (places.size() == things.size()) {
        return Optional.of(
            places.stream()
                .map(
                    place ->
                        phrases.of(
                            "one-at",
                            Map.of("one", instead, "preposition", word.get(), "place", place)))
                .toList());
      }
    }
    return Optional.empty();
  }

  private Optional<String> place(PredicateDeclaration predicate, Term.Name thing) {
    return places(predicate, thing).findFirst().map(naming::of);
  }

  private Stream<Term.Name> places(PredicateDeclaration predicate, Term.Name thing) {
    return relations.fits(predicate, 0, thing)
        ? situation.facts().individuals(Relations.typeOf(predicate, 1)).stream()
            .filter(place -> !place.equals(thing))
            .filter(place -> holds(predicate.name(), thing, place))
        : Stream.of();
  }

  private boolean holds(String predicate, Term thing, Term place) {
    return new Evaluation(situation.facts())
            .truth(new Formula.Atom(predicate, List.of(thing, place)), Map.of())
        == Truth.TRUE;
  }

  private String none(Form said) {
    if (said.is("speaker")) {
      return grammar.phrase("no-speaker");
    }
    if (said.is("self")) {
      return grammar.phrase("no-robot");
    }
    Reference of = new NounPhrases(situation).resolve(said, "");
    if (of instanceof Reference.Single single) {
      // It is there, and is not of the kind that can be, or do, what was said.
      return phrases.of("not-with", Map.of("what", naming.of(single.term())));
    }
    String named = named(said);
    boolean isUnnamed =
        isPronoun(said)
            || isOfAnything(said)
            || named.isBlank()
            || named.startsWith(" ")
            || isOfSuchAKind(said) && latestKind().isEmpty();
    return isUnnamed ? grammar.phrase("none-meant") : phrases.of("none", Map.of("what", named));
  }

  /** Whether it is one of a kind that was to be spoken of before. */
  private static boolean isOfSuchAKind(Form form) {
    return form.is("one") || form.parts().stream().anyMatch(QuestionsBack::isOfSuchAKind);
  }

  private static boolean isOfAnything(Form form) {
    return switch (form.head()) {
      case "everything", "any" -> true;
      case "np" -> isOfAnything(form.part(1));
      case "at" -> isOfAnything(form.part(0));
      case "noun" -> form.text(0).equals(NounPhrases.THING);
      default -> false;
    };
  }

  private static boolean isPronoun(Form form) {
    return form.is("it") || form.is("them") || form.is("him");
  }

  /** What was said, with the article of what it is. */
  private String named(Form form) {
    String article = phrases.article(called(form));
    return article.isEmpty() ? said(form) : article + " " + said(form);
  }

  /** What was said, as far as it has names. */
  private String said(Form form) {
    return switch (form.head()) {
      case "noun", "name" -> naming.bare(form.text(0));
      case "one" -> latestKind().map(naming::bare).orElse(grammar.phrase("it"));
      case "np" -> said(form.part(form.parts().size() - 1));
      case "mod" -> form.part(0).text(1) + " " + said(form.part(1));
      case "instate" -> inState(form.part(0)) + said(form.part(1));
      case "at" ->
          form.part(0).is("at")
              ? said(form.part(0))
              : said(form.part(0)) + " " + said(form.part(1));
      case "rel", "from", "within", "here", "there", "either", "each", "everywhere" ->
          grammar.phrase("there");
      case "any" -> "";
      case "it", "them", "him" -> grammar.phrase("it");
      case "beside" -> said(form.part(0)) + " " + said(form.part(1));
      case "of" ->
          form.part(0).parts().isEmpty()
              ? said(form.part(1))
              : phrases.of(
                  "owned", Map.of("whose", said(form.part(0)), "what", said(form.part(1))));
      default ->
          form.parts().isEmpty()
              ? naming.word(form.head())
              : said(form.part(form.parts().size() - 1));
    };
  }

  /** The name of what was said to be like that, or there; "" when it has none. */
  private String called(Form form) {
    if (form.is("of") || form.is("beside")) {
      return called(form.part(1));
    }
    if (form.is("one")) {
      return latestKind().map(naming::word).orElse("");
    }
    return form.is("noun") || form.is("name")
        ? naming.word(form.text(0))
        : form.parts().stream()
            .map(this::called)
            .filter(name -> !name.isEmpty())
            .findFirst()
            .orElse("");
  }

  /** The class that was spoken of last. */
  private Optional<String> latestKind() {
    return situation.discourse().classes().stream().findFirst();
  }

  private String inState(Form state) {
    return situation.home().wording().states().stream()
        .filter(word -> word.name().equals(state.text(0)))
        .flatMap(word -> word.says().stream())
        .filter(said -> said.isIn(grammar.language()))
        .map(said -> said.text() + " ")
        .findFirst()
        .orElse("");
  }
}
