package org.maestro.faults;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.ReadableByteChannel;
import java.nio.channels.WritableByteChannel;
import java.util.Random;

/** An open file of a {@link FaultyDisk}. */
final class FaultyChannel extends FileChannel {
  private final FaultyDisk disk;
  private final FileChannel real;
  private long forcedBytes;

  FaultyChannel(FaultyDisk disk, FileChannel real) throws IOException {
    this.disk = disk;
    this.real = real;
    this.forcedBytes = real.size();
  }

  /** As when the machine ends: the file goes on to a place between what was forced and all. */
  void loseUnforced(Random chance) throws IOException {
    long lost = real.size() - forcedBytes;
    if (lost > 0) {
      real.truncate(forcedBytes + (long) (chance.nextDouble() * (lost + 1)));
    }
  }

  @Override
  public int read(ByteBuffer into) throws IOException {
    long from = real.position();
    return flipped(into, from, real.read(into));
  }

  @Override
  public int read(ByteBuffer into, long from) throws IOException {
    return flipped(into, from, real.read(into, from));
  }

  private int flipped(ByteBuffer into, long from, int bytes) throws IOException {
    disk.requireThere();
    disk.flippedBit()
        .ifPresent(
            bit -> {
              long at = bit / Byte.SIZE - from;
              if (at >= 0 && at < bytes) {
                int index = into.position() - bytes + (int) at;
                into.put(index, (byte) (into.get(index) ^ 1 << bit % Byte.SIZE));
              }
            });
    return bytes;
  }

  @Override
  public int write(ByteBuffer from) throws IOException {
    ByteBuffer part = part(from, real.position());
    return written(from, part, real.write(part));
  }

  @Override
  public int write(ByteBuffer from, long at) throws IOException {
    ByteBuffer part = part(from, at);
    return written(from, part, real.write(part, at));
  }

  /** What is written over needs no room. */
  private ByteBuffer part(ByteBuffer from, long at) throws IOException {
    int over = (int) Math.max(0, Math.min(from.remaining(), real.size() - at));
    return from.slice(from.position(), disk.takes(over, from.remaining() - over));
  }

  private int written(ByteBuffer from, ByteBuffer part, int bytes) throws IOException {
    if (part.capacity() < from.remaining()) {
      throw disk.refusal();
    }
    from.position(from.position() + bytes);
    return bytes;
  }

  @Override
  public FileChannel truncate(long bytes) throws IOException {
    disk.requireWritable();
    real.truncate(bytes);
    forcedBytes = Math.min(forcedBytes, bytes);
    return this;
  }

  @Override
  public void force(boolean withMetadata) throws IOException {
    disk.awaitForced();
    real.force(withMetadata);
    forcedBytes = real.size();
  }

  @Override
  public long position() throws IOException {
    return real.position();
  }

  @Override
  public FileChannel position(long at) throws IOException {
    real.position(at);
    return this;
  }

  @Override
  public long size() throws IOException {
    return real.size();
  }

  @Override
  public FileLock lock(long at, long bytes, boolean shared) throws IOException {
    return real.lock(at, bytes, shared);
  }

  @Override
  public FileLock tryLock(long at, long bytes, boolean shared) throws IOException {
    return real.tryLock(at, bytes, shared);
  }

  @Override
  public long read(ByteBuffer[] into, int offset, int length) {
    throw new UnsupportedOperationException("Nobody reads into several buffers.");
  }

  @Override
  public long write(ByteBuffer[] from, int offset, int length) {
    throw new UnsupportedOperationException("Nobody writes from several buffers.");
  }

  @Override
  public long transferTo(long at, long bytes, WritableByteChannel to) {
    throw new UnsupportedOperationException("Nobody transfers.");
  }

  @Override
  public long transferFrom(ReadableByteChannel from, long at, long bytes) {
    throw new UnsupportedOperationException("Nobody transfers.");
  }

  @Override
  public MappedByteBuffer map(MapMode mode, long at, long bytes) {
    throw new UnsupportedOperationException("Nobody maps it.");
  }

  @Override
  protected void implCloseChannel() throws IOException {
    real.close();
    disk.closed(this);
  }
}
