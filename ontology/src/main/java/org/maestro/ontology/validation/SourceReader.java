package org.maestro.ontology.validation;

import com.apicatalog.jsonld.JsonLdError;
import com.apicatalog.jsonld.JsonLdErrorCode;
import com.apicatalog.jsonld.JsonLdOptions;
import com.apicatalog.jsonld.document.Document;
import com.apicatalog.jsonld.document.JsonDocument;
import com.apicatalog.jsonld.loader.DocumentLoader;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.regex.Pattern;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.Triple;
import org.apache.jena.irix.IRIxResolver;
import org.apache.jena.riot.Lang;
import org.apache.jena.riot.RIOT;
import org.apache.jena.riot.RiotException;
import org.apache.jena.riot.lang.LangJSONLD11;
import org.apache.jena.riot.lang.RiotParsers;
import org.apache.jena.riot.system.ErrorHandler;
import org.apache.jena.riot.system.FactoryRDFStd;
import org.apache.jena.riot.system.ParserProfile;
import org.apache.jena.riot.system.ParserProfileStd;
import org.apache.jena.riot.system.ParserProfileWrapper;
import org.apache.jena.riot.system.PrefixMapFactory;
import org.apache.jena.riot.system.StreamRDFBase;
import org.apache.jena.sparql.util.Context;
import org.apache.jena.sys.JenaSystem;

/** Reads one text into a {@link SourceGraph} and notes the line of every statement. */
public final class SourceReader {

  /** The one JSON-LD context that descriptions may refer to; it is on the class path. */
  public static final String CONTEXT_IRI = "https://w3id.org/maestro/context.jsonld";

  private static final String CONTEXT_RESOURCE = "/org/maestro/ontology/context.jsonld";

  /**
   * Jena by itself takes a last statement without its dot, and so a file of which half is there.
   */
  private static final boolean STRICT = true;

  private static final boolean LENIENT = false;

  static {
    JenaSystem.init();
  }

  private final SourceGraph graph;
  private final String source;
  private final String base;

  /**
   * @param source how faults call the text
   * @param base against which relative IRIs are resolved
   */
  public SourceReader(SourceGraph graph, String source, String base) {
    this.graph = graph;
    this.source = source;
    this.base = base;
  }

  /** Reads until the end or the first syntax error, which becomes a fault. */
  public void readTurtle(String text) {
    read(
        RiotParsers.factoryTTL.create(Lang.TURTLE, profile(STRICT)),
        text,
        RIOT.getContext().copy());
  }

  /**
   * Reads a JSON-LD document; contexts other than {@link #CONTEXT_IRI} or inline ones are faults.
   */
  public void readJsonLd(String text) {
    JsonOutline outline = new JsonOutline(text, source);
    outline.faults().forEach(graph::fault);
    if (!outline.faults().isEmpty()) {
      return;
    }
    JsonOutline.usualPrefixes().forEach(graph::usualPrefix);
    JsonLdOptions options = new JsonLdOptions((DocumentLoader) (url, loading) -> context(url));
    Context context = RIOT.getContext().copy();
    context.set(LangJSONLD11.JSONLD_OPTIONS, options);
    read(new LangJSONLD11(Lang.JSONLD11, profile(LENIENT), new Complaints()), text, context);
  }

  private void read(org.apache.jena.riot.ReaderRIOT reader, String text, Context context) {
    try {
      reader.read(new StringReader(text), base, Lang.TURTLE.getContentType(), new Sink(), context);
    } catch (SyntaxFound e) {
      graph.fault(e.fault);
    } catch (RiotException e) {
      graph.fault(
          new Fault(source, 0, "the text", "", "cannot be read: " + e.getMessage(), "write RDF"));
    }
  }

  private ParserProfile profile(boolean isStrict) {
    ParserProfile standard =
        new ParserProfileStd(
            new FactoryRDFStd(),
            new Complaints(),
            IRIxResolver.create(base).build(),
            PrefixMapFactory.create(),
            RIOT.getContext().copy(),
            true,
            isStrict);
    return new ParserProfileWrapper(standard) {
      @Override
      public Triple createTriple(Node s, Node p, Node o, long line, long column) {
        Triple triple = super.createTriple(s, p, o, line, column);
        graph.add(triple, new SourceGraph.Origin(source, (int) Math.max(0, line)));
        return triple;
      }
    };
  }

  private static Document context(java.net.URI url) throws JsonLdError {
    if (!url.toString().equals(CONTEXT_IRI)) {
      throw new JsonLdError(
          JsonLdErrorCode.LOADING_REMOTE_CONTEXT_FAILED,
          "the context " + url + " is not known; use " + CONTEXT_IRI + " or an inline context");
    }
    return OurContext.DOCUMENT;
  }

  /** Read when first needed; it does not change. */
  private static final class OurContext {
    static final Document DOCUMENT = read();

    private static Document read() {
      try {
        return JsonDocument.of(new StringReader(contextText()));
      } catch (JsonLdError e) {
        throw new IllegalStateException("The context " + CONTEXT_IRI + " cannot be read.", e);
      }
    }
  }

  /** What stands at {@link #CONTEXT_IRI}. */
  static String contextText() {
    try (InputStream stream = SourceReader.class.getResourceAsStream(CONTEXT_RESOURCE)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException("The context " + CONTEXT_IRI + " cannot be read.", e);
    }
  }

  /** Keeps what is stated; the triples themselves are noted where their lines are known. */
  private final class Sink extends StreamRDFBase {
    @Override
    public void prefix(String prefix, String iri) {
      graph.prefix(prefix, iri);
    }

    @Override
    public void triple(Triple triple) {
      graph.add(triple, new SourceGraph.Origin(source, 0));
    }

    @Override
    public void quad(org.apache.jena.sparql.core.Quad quad) {
      graph.add(quad.asTriple(), new SourceGraph.Origin(source, 0));
    }
  }

  /** Makes faults of the parser's complaints. */
  private final class Complaints implements ErrorHandler {

    /** Durations are checked where they are understood, with an example. */
    private static final List<String> HARMLESS =
        List.of("not in preferred form", "not valid for datatype XSD duration");

    private static final Pattern UNDEFINED = Pattern.compile("Undefined prefix: (\\S*)");

    @Override
    public void warning(String message, long line, long column) {
      if (HARMLESS.stream().noneMatch(message::contains)) {
        graph.fault(fault(message, line, column));
      }
    }

    @Override
    public void error(String message, long line, long column) {
      throw new SyntaxFound(fault(message, line, column));
    }

    @Override
    public void fatal(String message, long line, long column) {
      throw new SyntaxFound(fault(message, line, column));
    }

    private Fault fault(String message, long line, long column) {
      String where = column > 0 ? " (column " + column + ")" : "";
      return new Fault(
          source,
          (int) Math.max(0, line),
          "the text",
          "",
          "has a fault" + where + ": " + message,
          cure(message));
    }

    private static String cure(String message) {
      return UNDEFINED.matcher(message).matches()
          ? UNDEFINED
              .matcher(message)
              .replaceFirst("declare it above, @prefix $1: <...> ., or write one that is declared")
          : "correct it there or just before";
    }
  }

  /** Ends the reading of a text that is no RDF. */
  private static final class SyntaxFound extends RuntimeException {

    private static final long serialVersionUID = 1L;

    private final transient Fault fault;

    SyntaxFound(Fault fault) {
      super(fault.toString());
      this.fault = fault;
    }
  }
}
