package org.maestro.knowledge.rdf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.UUID;
import java.util.stream.Stream;
import org.apache.jena.dboe.base.file.Location;
import org.apache.jena.dboe.transaction.txn.journal.Journal;
import org.apache.jena.dboe.transaction.txn.journal.JournalEntry;
import org.apache.jena.dboe.transaction.txn.journal.JournalEntryType;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;
import org.apache.jena.sparql.core.Quad;
import org.apache.jena.tdb2.sys.ComponentIdMgr;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.knowledge.api.KnowledgeException;

/**
 * What a kill leaves, moment by moment: the second of two transactions, its blocks written, its
 * journal cut short or whole, its states in force in part.
 */
class StoreFilesTest {
  private static final int BEFORE = 300;
  private static final int AFTER = 600;

  @TempDir Path directory;
  private Path store;
  private Path data;

  /** The contents of each state file, in force after the first transaction and after the second. */
  private final Map<Path, byte[]> before = new TreeMap<>();

  private final Map<Path, byte[]> after = new TreeMap<>();

  @BeforeEach
  void twoTransactions() throws IOException {
    store = directory.resolve("store");
    data = store.resolve("Data-0001");
    write(0, BEFORE);
    before.putAll(states());
    write(BEFORE, AFTER);
    after.putAll(states());
    assertThat(statements()).isEqualTo(AFTER);
  }

  private void write(int from, int to) {
    DatasetStorage storage = DatasetStorage.onDisk(store);
    Node graph = NodeFactory.createURI("urn:graph");
    List<Quad> added =
        Stream.iterate(from, number -> number + 1)
            .limit(to - from)
            .map(number -> NodeFactory.createURI("urn:" + number))
            .map(node -> Quad.create(graph, node, node, node))
            .toList();
    storage.commit(List.of(), List.of(), added);
    storage.close();
  }

  private int statements() {
    DatasetStorage storage = DatasetStorage.onDisk(store);
    try {
      return storage.select("SELECT ?s { GRAPH <urn:graph> { ?s ?p ?o } }").size();
    } finally {
      storage.close();
    }
  }

  private Map<Path, byte[]> states() throws IOException {
    Map<Path, byte[]> states = new TreeMap<>();
    try (Stream<Path> files = Files.list(data)) {
      for (Path file : files.filter(path -> path.toString().matches(".*\\.(bpt|bdf)")).toList()) {
        states.put(file, Files.readAllBytes(file));
      }
    }
    return states;
  }

  /** The journal of the second transaction. */
  private byte[] journal() throws IOException {
    Location place = Location.create(Files.createTempDirectory(directory, "journal"));
    Journal journal = Journal.create(place);
    ComponentIdMgr numbers = new ComponentIdMgr(UUID.randomUUID());
    after.forEach(
        (file, state) ->
            journal.write(
                JournalEntryType.REDO,
                numbers.getComponentId(file.getFileName().toString().replaceAll("\\..*", "")),
                ByteBuffer.wrap(state)));
    journal.writeJournal(JournalEntry.COMMIT);
    journal.sync();
    journal.close();
    return Files.readAllBytes(Path.of(place.getPath("journal.jrnl")));
  }

  private void leave(Path copied, byte[] journal, int inForce) throws IOException {
    copy(store, copied);
    store = copied;
    data = copied.resolve("Data-0001");
    Files.write(data.resolve("journal.jrnl"), journal);
    int number = 0;
    for (Map.Entry<Path, byte[]> state : before.entrySet()) {
      if (number++ >= inForce) {
        Files.write(data.resolve(state.getKey().getFileName()), state.getValue());
      }
    }
  }

  private static void copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.walk(from)) {
      files.forEach(
          file -> {
            try {
              Files.copy(file, to.resolve(from.relativize(file)));
            } catch (IOException e) {
              throw new UncheckedIOException(e);
            }
          });
    }
  }

  @Test
  void whatWasCommittedIsThereHoweverMuchOfItWasInForce() throws IOException {
    Path whole = store;
    byte[] journal = journal();
    for (int inForce = 0; inForce <= before.size(); inForce += 2) {
      store = whole;
      leave(directory.resolve("in-force-" + inForce), journal, inForce);
      assertThat(statements()).as("%d states in force", inForce).isEqualTo(AFTER);
      write(AFTER, AFTER + 1);
      assertThat(statements()).isEqualTo(AFTER + 1);
    }
  }

  @Test
  void whatWasNotCommittedIsNotThereWhereverItsJournalEnds() throws IOException {
    Path whole = store;
    byte[] journal = journal();
    for (int bytes = 0; bytes < journal.length; bytes += 43) {
      store = whole;
      leave(directory.resolve("cut-" + bytes), Arrays.copyOf(journal, bytes), 0);
      assertThat(statements()).as("%d bytes of %d", bytes, journal.length).isEqualTo(BEFORE);
      write(BEFORE, BEFORE + 1);
      assertThat(statements()).isEqualTo(BEFORE + 1);
    }
  }

  /** The states say that there is nothing yet, whatever has been written of the empty trees. */
  @Test
  void aStoreThatWasOnlyBegunIsMadeAnew() throws IOException {
    Path whole = store;
    for (String begun : List.of("dat", "dat|idn")) {
      Path copied = directory.resolve("begun-" + begun.length());
      store = whole;
      leave(copied, new byte[0], 0);
      try (Stream<Path> files = Files.list(data)) {
        for (Path file : files.filter(path -> !path.toString().endsWith("cfg")).toList()) {
          if (file.toString().endsWith("bpt")) {
            Files.write(file, new byte[3 * Long.BYTES]);
          } else if (file.toString().matches(".*[.](" + begun + ")")) {
            Files.write(file, new byte[8192]);
          } else {
            Files.delete(file);
          }
        }
      }
      assertThat(statements()).as("with %s", begun).isZero();
      write(0, 1);
      assertThat(statements()).isEqualTo(1);
    }
  }

  @Test
  void aJournalThatIsDamagedIsToldAndNothingOfItIsPutInForce() throws IOException {
    byte[] journal = journal();
    journal[journal.length / 2] ^= 1;
    leave(directory.resolve("damaged"), journal, 0);
    assertThatThrownBy(this::statements)
        .isInstanceOf(KnowledgeException.class)
        .hasMessageContaining("The store in " + store)
        .hasMessageContaining("put a copy in its place");
    for (Map.Entry<Path, byte[]> state : before.entrySet()) {
      assertThat(data.resolve(state.getKey().getFileName())).hasBinaryContent(state.getValue());
    }
  }

  @Test
  void aFileThatEndsTooEarlyIsNamedBeforeAnythingIsWritten() throws IOException {
    Path cut = data.resolve("GSPO.dat");
    long bytes = Files.size(cut);
    try (FileChannel channel = FileChannel.open(cut, StandardOpenOption.WRITE)) {
      channel.truncate(bytes - 8192);
    }
    assertThatThrownBy(this::statements)
        .hasMessage(
            "The store in %s cannot be read (GSPO.dat has %d bytes of %d); put a copy in its place, or move it away to begin without what was known."
                .formatted(store, bytes - 8192, bytes));
    assertThat(Files.size(cut)).isEqualTo(bytes - 8192);
  }
}
