package org.maestro.ontology.validation;

import jakarta.json.stream.JsonParsingException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What of a description in JSON-LD shows before it is understood as statements: whether it is JSON,
 * has its context, an id and a type, says nothing twice; and at which line what is said.
 */
public final class JsonOutline {

  private static final String EXAMPLE_ID = "\"id\": \"https://example.org/devices#lamp-1\"";
  private static final JsonText OURS =
      ((JsonText.Members) JsonText.parse(SourceReader.contextText()))
          .value("@context")
          .orElseThrow();

  private static final Pattern PREFIX = Pattern.compile("([A-Za-z][\\w.-]*):(?!//)");
  private static final Set<String> SCHEMES = Set.of("urn", "tag", "did", "info", "mailto", "data");
  private static final Set<String> NAMES =
      Set.of("id", "type", "types", "needs", "subClassOf", "equivalentClass", "equivalentProperty");

  private final String source;
  private final List<Fault> faults = new ArrayList<>();
  private final List<Fault> unknown = new ArrayList<>();
  private final JsonPlaces places = new JsonPlaces();
  private final Set<String> described = new LinkedHashSet<>();

  /**
   * @param source how faults call the text
   */
  public JsonOutline(String text, String source) {
    this.source = source;
    try {
      JsonText whole = JsonText.parse(text);
      whole.each().forEach(this::document);
    } catch (JsonParsingException e) {
      noJson(text, e);
    }
  }

  private void noJson(String text, JsonParsingException e) {
    long last = Math.max(1, text.stripTrailing().lines().count());
    boolean isTheEnd = e.getLocation().getLineNumber() > last || text.isBlank();
    int line = (int) Math.max(1, Math.min(last, e.getLocation().getLineNumber()));
    long column = e.getLocation().getColumnNumber();
    fault(
        line,
        "the text",
        isTheEnd
            ? "has a fault: it ends before it is complete"
            : "has a fault (column %d): it is no JSON there".formatted(column),
        isTheEnd
            ? "close what is open, such as { with }, and [ with ]"
            : "put in what is missing there or just before, such as a comma, a quote or a bracket,"
                + " or leave out what is too much");
  }

  /** Namespaces of prefixes that {@link SourceReader#CONTEXT_IRI} defines. */
  static Map<String, String> usualPrefixes() {
    Map<String, String> prefixes = new TreeMap<>();
    for (JsonText.Member member : ((JsonText.Members) OURS).all()) {
      if (member.value() instanceof JsonText.Scalar namespace
          && namespace.text().matches("http.*[#/]")) {
        prefixes.put(member.key(), namespace.text());
      }
    }
    return prefixes;
  }

  /** What makes it useless. */
  public List<Fault> faults() {
    return List.copyOf(faults);
  }

  /** Keys and prefixes that no context defines, so that nothing comes of what they say. */
  public List<Fault> unknownWords() {
    return List.copyOf(unknown);
  }

  /** The fault with the line of what it speaks of, as far as that is plain. */
  public Fault placed(Fault fault) {
    return places.placed(fault);
  }

  private void document(JsonText text) {
    if (!(text instanceof JsonText.Members document)) {
      fault(text.line(), "the text", "describes no device", "write an object, { ... }");
      return;
    }
    JsonTerms terms = JsonTerms.NONE.with(document, OURS);
    if (isElsewhere(document)) {
      return;
    }
    boolean hasBareWords = document.all().stream().anyMatch(member -> !isWritten(member.key()));
    if (hasBareWords && !terms.knows("id") && !terms.knows("type")) {
      fault(
          document.line(),
          "the text",
          document.value("@context").isEmpty()
              ? "has no @context, so that its words mean nothing"
              : "has a @context that does not say what id and type mean",
          "write \"@context\": \"%s\", or that and your own in a list"
              .formatted(SourceReader.CONTEXT_IRI));
      return;
    }
    boolean isOne = document.value("@graph").isEmpty();
    if (isOne && lacks(document, "id", "@id", terms)) {
      fault(document.line(), "the device", "has no id", "write one, such as " + EXAMPLE_ID);
    } else if (isOne && lacks(document, "type", "@type", terms)) {
      fault(
          JsonPlaces.line(document),
          name(document).orElse("the device"),
          "has no type",
          "write \"type\": \"maestro:Device\", or a class under it, such as \"domain:Lamp\"");
    }
    object(document, JsonTerms.NONE, "the device", "");
  }

  /** What only the network could tell is not asked for. */
  private boolean isElsewhere(JsonText.Members document) {
    for (JsonText context : document.value("@context").map(JsonText::each).orElse(List.of())) {
      if (context instanceof JsonText.Scalar scalar
          && !scalar.text().equals(SourceReader.CONTEXT_IRI)) {
        fault(
            context.line(),
            "the text",
            "has the @context " + scalar.text() + ", which nobody knows here",
            "write \"%s\", and your own words as an object beside it"
                .formatted(SourceReader.CONTEXT_IRI));
        return true;
      }
    }
    return false;
  }

  private static boolean isWritten(String key) {
    return key.startsWith("@") || key.contains(":");
  }

  /** Whether a keyword is not there, by whatever name. */
  private static boolean lacks(
      JsonText.Members document, String usual, String keyword, JsonTerms terms) {
    boolean isRenamed =
        document.value("@context").stream()
            .flatMap(context -> context.each().stream())
            .filter(JsonText.Members.class::isInstance)
            .flatMap(context -> ((JsonText.Members) context).all().stream())
            .filter(term -> term.value() instanceof JsonText.Scalar to && to.text().equals(keyword))
            .anyMatch(term -> document.value(term.key()).isPresent());
    return !isRenamed
        && document.value(keyword).isEmpty()
        && !(terms.knows(usual) && document.value(usual).isPresent());
  }

  private void object(JsonText.Members object, JsonTerms outer, String owner, String under) {
    JsonTerms terms = outer.with(object, OURS);
    String subject = name(object).orElse(owner);
    name(object).ifPresent(name -> note(name, object, under));
    checkIri(object, subject);
    Set<String> seen = new LinkedHashSet<>();
    for (JsonText.Member member : object.all()) {
      checkPrefix(member.key(), member.line(), subject, terms);
      if (NAMES.contains(member.key())) {
        member
            .value()
            .each()
            .forEach(
                value -> {
                  if (value instanceof JsonText.Scalar name) {
                    checkPrefix(name.text(), name.line(), subject, terms);
                  }
                });
      }
      if (!seen.add(member.key())) {
        fault(member.line(), subject, "says \"" + member.key() + "\" twice", "keep one of both");
      }
      if (!terms.knows(member.key())) {
        unknown.add(
            new Fault(
                source,
                member.line(),
                subject,
                member.key(),
                "is no word of the context, and nothing comes of it",
                Nearest.cure(
                    member.key(),
                    terms.words(),
                    word -> "\"" + word + "\"",
                    "leave it away, or give it a prefix that your @context defines")));
      } else if (!member.key().equals("@context") && !terms.opaque().contains(member.key())) {
        for (JsonText value : member.value().each()) {
          if (value instanceof JsonText.Members inner) {
            object(inner, terms, subject, member.key());
          }
        }
      }
    }
  }

  private void checkIri(JsonText.Members object, String subject) {
    if (object.value("id").orElse(object) instanceof JsonText.Scalar id
        && id.text().matches(".*\\s.*")) {
      fault(
          id.line(),
          subject,
          "has a blank in its id",
          "write letters, digits and hyphens, such as " + EXAMPLE_ID);
    }
  }

  /** A prefix that no context defines makes another name than is meant. */
  private void checkPrefix(String name, int line, String subject, JsonTerms terms) {
    Matcher prefix = PREFIX.matcher(name);
    if (prefix.lookingAt()
        && !SCHEMES.contains(prefix.group(1))
        && !terms.words().contains(prefix.group(1))) {
      unknown.add(
          new Fault(
              source,
              line,
              subject,
              name,
              "has the prefix %s:, which no context defines".formatted(prefix.group(1)),
              Nearest.cure(
                  prefix.group(1),
                  terms.words(),
                  word -> word + ":",
                  "define it in @context, such as {\"%s\": \"https://example.org/words#\"}"
                      .formatted(prefix.group(1)))));
    }
  }

  /** A node that is described, not only named. */
  private void note(String name, JsonText.Members object, String under) {
    if (object.all().size() == 1) {
      return;
    }
    places.note(name, object);
    if (under.equals("offers") && !described.add(name)) {
      fault(
          JsonPlaces.line(object),
          name,
          "is offered twice",
          "keep one of both, or give one another id");
    }
  }

  private static Optional<String> name(JsonText.Members object) {
    return object
        .value("id")
        .or(() -> object.value("@id"))
        .filter(JsonText.Scalar.class::isInstance)
        .map(id -> ((JsonText.Scalar) id).text())
        .map(id -> Maestro.localName(id.substring(id.lastIndexOf(':') + 1)));
  }

  private void fault(int line, String subject, String problem, String cure) {
    faults.add(new Fault(source, line, subject, "", problem, cure));
  }
}
