package org.maestro.knowledge.rdf;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.apache.jena.dboe.base.file.BufferChannel;
import org.apache.jena.dboe.base.file.BufferChannelFile;
import org.apache.jena.dboe.base.file.BufferChannelMem;
import org.apache.jena.dboe.base.file.Location;
import org.apache.jena.dboe.base.file.ProcessFileLock;
import org.apache.jena.dboe.sys.Names;
import org.apache.jena.dboe.sys.SystemIndex;
import org.apache.jena.dboe.transaction.txn.TransactionException;
import org.apache.jena.dboe.transaction.txn.journal.Journal;
import org.apache.jena.dboe.transaction.txn.journal.JournalEntry;
import org.apache.jena.dboe.transaction.txn.journal.JournalEntryType;
import org.apache.jena.tdb2.sys.ComponentIdMgr;
import org.apache.jena.tdb2.sys.DatabaseConnection;

/**
 * The files of a TDB2 store before TDB2 opens them. After a kill, TDB2 5.6 refuses a journal that
 * was cut short; it loses what a whole one says was committed, as it first cuts files that are not
 * mapped into memory to the lengths that were in force before; and it takes a tree that was only
 * begun for a whole one. So this is seen to here: what was committed is put in force, and what was
 * not, is dropped.
 */
final class StoreFiles {
  private static final String GENERATION = "Data-";

  private static final List<Extent> TREES =
      List.of(
          new Extent(Names.extBptState, 1, Names.extBptTree, SystemIndex.BlockSize),
          new Extent(Names.extBptState, 2, Names.extBptRecords, SystemIndex.BlockSize));

  private static final List<Extent> EXTENTS =
      List.of(
          TREES.get(0), TREES.get(1), new Extent(Names.extBdfState, 0, Names.extObjNodeData, 1));

  private final Path container;

  StoreFiles(Path container) {
    this.container = container;
  }

  /**
   * Does nothing while another process, or this one, has the store open.
   *
   * @throws IOException when a file cannot be read or written
   */
  void settle() throws IOException {
    Optional<Path> data = generation();
    if (data.isEmpty()) {
      return;
    }
    ProcessFileLock lock = DatabaseConnection.lockForLocation(Location.create(container));
    if (lock.isLockedHere() || !lock.tryLock()) {
      return;
    }
    try {
      settleJournal(data.get());
      cutToExtents(data.get());
    } finally {
      lock.unlock();
      ProcessFileLock.release(lock);
    }
  }

  /** The newest, which is the one that is opened. */
  private Optional<Path> generation() throws IOException {
    try (Stream<Path> inside = Files.list(container)) {
      return inside
          .filter(path -> path.getFileName().toString().matches(GENERATION + "\\d+"))
          .max((a, b) -> Long.compare(number(a), number(b)));
    }
  }

  private static long number(Path generation) {
    return Long.parseLong(generation.getFileName().toString().substring(GENERATION.length()));
  }

  private static void settleJournal(Path data) throws IOException {
    Path file = data.resolve(Names.journalFile);
    if (!Files.exists(file) || Files.size(file) == 0) {
      return;
    }
    boolean committed = endsWithCommit(file);
    Journal journal = Journal.create(BufferChannelFile.createUnmanaged(file.toString(), "rw"));
    try {
      if (committed) {
        putInForce(journal, data);
      } else {
        journal.reset();
      }
    } finally {
      journal.close();
    }
  }

  /** Its bytes are looked at: what TDB2 took for an entry might have any length. */
  private static boolean endsWithCommit(Path journal) throws IOException {
    byte[] commit = commit();
    byte[] all = Files.readAllBytes(journal);
    int begin = all.length - commit.length;
    return begin >= 0 && Arrays.equals(all, begin, all.length, commit, 0, commit.length);
  }

  /** The entry that TDB2 ends a transaction with. */
  private static byte[] commit() {
    BufferChannel channel = BufferChannelMem.create("commit");
    Journal.create(channel).writeJournal(JournalEntry.COMMIT);
    ByteBuffer bytes = ByteBuffer.allocate((int) channel.size());
    channel.read(bytes, 0);
    return bytes.array();
  }

  /**
   * The journal stays as it is: TDB2 reads it once more, and finds all of it done.
   *
   * @throws TransactionException before anything is written, when it is damaged
   */
  private static void putInForce(Journal journal, Path data) throws IOException {
    Map<Integer, Path> states = states(data);
    List<JournalEntry> entries = new ArrayList<>();
    journal.entries().forEachRemaining(entries::add);
    for (JournalEntry entry : entries) {
      Path state = states.get(ByteBuffer.wrap(entry.getComponentId().getBytes()).getInt());
      if (entry.getType() == JournalEntryType.REDO && state != null) {
        write(state, entry.getByteBuffer().rewind());
      }
    }
  }

  /** By the number that the journal has for each. */
  private static Map<Integer, Path> states(Path data) throws IOException {
    Map<Integer, Path> states = new HashMap<>();
    for (String extension : List.of(Names.extBptState, Names.extBdfState)) {
      for (Path state : files(data, extension)) {
        states.put(ComponentIdMgr.getIndex(base(state)), state);
      }
    }
    return states;
  }

  private static List<Path> files(Path data, String extension) throws IOException {
    try (Stream<Path> inside = Files.list(data)) {
      return inside.filter(path -> path.toString().endsWith("." + extension)).sorted().toList();
    }
  }

  private static String base(Path file) {
    String name = file.getFileName().toString();
    return name.substring(0, name.lastIndexOf('.'));
  }

  private static void write(Path file, ByteBuffer bytes) throws IOException {
    try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
      long position = 0;
      while (bytes.hasRemaining()) {
        position += channel.write(bytes, position);
      }
      channel.force(true);
    }
  }

  /** What is beyond belongs to no transaction: TDB2 cuts it off too, but has counted it before. */
  private static void cutToExtents(Path data) throws IOException {
    for (Extent extent : TREES) {
      for (Path state : files(data, extent.stateExtension())) {
        Path file = extent.of(state);
        long said = extent.bytes(state);
        if (Files.exists(file) && Files.size(file) > said) {
          try (FileChannel channel = FileChannel.open(file, StandardOpenOption.WRITE)) {
            channel.truncate(said);
          }
        }
      }
    }
  }

  /**
   * What is missing at a file's end, a sentence's part; empty when each is as long as was said when
   * it was written last. To be asked when they are settled.
   */
  Optional<String> missing() throws IOException {
    Optional<Path> data = generation();
    if (data.isEmpty()) {
      return Optional.empty();
    }
    for (Extent extent : EXTENTS) {
      for (Path state : files(data.get(), extent.stateExtension())) {
        Path file = extent.of(state);
        long bytes = Files.exists(file) ? Files.size(file) : 0;
        long said = extent.bytes(state);
        if (bytes < said) {
          return Optional.of("%s has %d bytes of %d".formatted(file.getFileName(), bytes, said));
        }
      }
    }
    return Optional.empty();
  }

  /**
   * A kind of file whose length stands, in units, at a place of a state file.
   *
   * @param place of the number among those of eight bytes
   */
  private record Extent(String stateExtension, int place, String extension, long unitBytes) {
    Path of(Path state) {
      return state.resolveSibling(base(state) + "." + extension);
    }

    /** Nothing is said by a state that is not written yet. */
    long bytes(Path state) throws IOException {
      ByteBuffer numbers = ByteBuffer.wrap(Files.readAllBytes(state));
      int position = place * Long.BYTES;
      return position + Long.BYTES > numbers.limit() ? 0 : numbers.getLong(position) * unitBytes;
    }
  }
}
