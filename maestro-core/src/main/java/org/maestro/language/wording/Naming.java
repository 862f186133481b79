package org.maestro.language.wording;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.ClassDeclaration;
import org.maestro.ontology.wording.Said;
import org.maestro.sl.Term;

/** How things are called in a language. Immutable. */
public final class Naming {
  private static final Pattern WORD = Pattern.compile("[A-Za-z][\\w-]*");
  private static final String PLURAL = "plural";

  private final Home home;
  private final Grammar grammar;

  public Naming(Home home, Grammar grammar) {
    this.home = home;
    this.grammar = grammar;
  }

  /** A thing's name, with the article that it has. */
  public String of(Term term) {
    return term instanceof Term.Name name ? word(name.text()) : String.valueOf(term);
  }

  /** What a class, a predicate or a thing is called; its id where it has no name. */
  public String word(String name) {
    return said(name)
        .or(() -> Optional.ofNullable(home.individuals().get(name)).map(Individual::label))
        .orElse(name);
  }

  /** Whether it has a name in this language, or one that counts for all. */
  boolean isNamed(String name) {
    return said(name).isPresent();
  }

  /** The same without its article. */
  public String bare(String name) {
    return withoutArticle(word(name));
  }

  private String withoutArticle(String word) {
    int blank = word.indexOf(' ');
    return blank > 0 && isArticle(word.substring(0, blank)) ? word.substring(blank + 1) : word;
  }

  /** Several of what is called so, without an article. */
  String plural(String kind) {
    String bare = withoutArticle(kind);
    int last = bare.lastIndexOf(' ') + 1;
    String noun = bare.substring(last);
    String plural = grammar.inflection().of(noun.toLowerCase(Locale.ROOT), PLURAL);
    boolean isCapital = Character.isUpperCase(noun.codePointAt(0));
    return bare.substring(0, last) + (isCapital ? Phrases.capitalized(plural) : plural);
  }

  private Optional<String> said(String name) {
    List<Said> all = home.wording().names().getOrDefault(name, List.of());
    return all.stream().filter(said -> said.isIn(grammar.language())).map(Said::text).findFirst();
  }

  /** A text that speaks of things by their ids, in which they have their names instead. */
  public String inText(String text) {
    Matcher words = WORD.matcher(text);
    StringBuilder named = new StringBuilder();
    String before = "";
    while (words.find()) {
      String word = words.group();
      words.appendReplacement(named, Matcher.quoteReplacement(nameAfter(before, word)));
      before = word;
    }
    words.appendTail(named);
    return named.toString();
  }

  /** No name has a second article. */
  private String nameAfter(String before, String word) {
    return !home.individuals().containsKey(word)
        ? word
        : isArticle(before) ? bare(word) : word(word);
  }

  private boolean isArticle(String word) {
    return grammar.list("article").contains(List.of(word.toLowerCase(Locale.ROOT)));
  }

  /** What the class of a thing is called: the narrowest that has a name. */
  public Optional<String> kind(Term.Name name) {
    Individual individual = home.individuals().get(name.text());
    if (individual == null) {
      return Optional.empty();
    }
    return individual.classes().stream()
        .map(one -> home.vocabulary().classes().get(one))
        .filter(Objects::nonNull)
        .max(Comparator.comparingInt(one -> one.ancestors().size()))
        .map(ClassDeclaration::name)
        .map(this::word);
  }
}
